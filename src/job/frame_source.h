// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/sha256.h"
#include "image/frame.h"

namespace poinsot::job {

/// Source of frames. Each frame depends on its number alone, so frames may be made in any order.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// Returns frame k, which is valid until the next call. @throws core::Error
  virtual image::Frame frame(std::int64_t k) = 0;
  /// Returns the digest of everything that decides the bytes of frame k. Costs far less than frame(). @throws
  /// core::Error
  virtual core::Digest digest(std::int64_t k) = 0;
};

}  // namespace poinsot::job
