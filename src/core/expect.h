// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::core {

/// Throws std::logic_error naming the condition and its place.
[[noreturn]] void brokenContract(const char* condition, const char* file, int line);

}  // namespace poinsot::core

/// A contract of the caller, always checked. Bad input is core::Error instead.
#define POINSOT_EXPECT(condition) \
  ((condition) ? static_cast<void>(0) : ::poinsot::core::brokenContract(#condition, __FILE__, __LINE__))

/// A fact the code relies on, checked in Debug builds only.
#ifdef NDEBUG
#define POINSOT_ASSERT(condition) static_cast<void>(0)
#else
#define POINSOT_ASSERT(condition) POINSOT_EXPECT(condition)
#endif
