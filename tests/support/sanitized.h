// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot {

/// Whether the program and its tests are built with AddressSanitizer or ThreadSanitizer. Both lay out terabytes of
/// address space and double what is held, so that limits on memory say nothing of the program.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace poinsot

/// In a test that no sanitizer can watch.
#define POINSOT_NOT_SANITIZED(why) \
  if (poinsot::kSanitized) GTEST_SKIP() << "under a sanitizer: " << (why)
