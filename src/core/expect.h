// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::core {

[[noreturn]] void brokenContract(const char* condition, const char* file, int line);

}  // namespace poinsot::core

/// Throws std::logic_error, in all builds, if `condition` is false, because then the caller has a bug. For invalid
/// input, throw core::Error instead.
#define POINSOT_EXPECT(condition) \
  ((condition) ? static_cast<void>(0) : ::poinsot::core::brokenContract(#condition, __FILE__, __LINE__))

/// Throws std::logic_error, in Debug builds only, if `condition` is false.
#ifdef NDEBUG
#define POINSOT_ASSERT(condition) static_cast<void>(0)
#else
#define POINSOT_ASSERT(condition) POINSOT_EXPECT(condition)
#endif
