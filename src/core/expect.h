// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::core {

[[noreturn]] void brokenContract(const char* condition, const char* file, int line);

}  // namespace poinsot::core

/// Throws std::logic_error, in all builds, if the caller breaks a contract: `condition` is false. Bad input throws
/// core::Error instead.
#define POINSOT_EXPECT(condition) \
  ((condition) ? static_cast<void>(0) : ::poinsot::core::brokenContract(#condition, __FILE__, __LINE__))

/// Throws std::logic_error, in Debug builds only, if `condition` is false.
#ifdef NDEBUG
#define POINSOT_ASSERT(condition) static_cast<void>(0)
#else
#define POINSOT_ASSERT(condition) POINSOT_EXPECT(condition)
#endif
