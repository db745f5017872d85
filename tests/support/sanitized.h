// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot {

/// Whether the program and its tests are built with AddressSanitizer or ThreadSanitizer. Both reserve terabytes of
/// address space and double the memory in use, so that limits on memory mean nothing there.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace poinsot

/// Skips a test that cannot run under a sanitizer.
#define POINSOT_NOT_SANITIZED(why) \
  if (poinsot::kSanitized) GTEST_SKIP() << "under a sanitizer: " << (why)
