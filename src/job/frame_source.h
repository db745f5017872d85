// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/sha256.h"
#include "image/frame.h"

namespace poinsot::job {

/// Source of frames. A frame depends only on its number, so frames may be requested in any order.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// Returns frame k, which is valid until the next call. @throws core::Error
  virtual image::Frame frame(std::int64_t k) = 0;
  /// Returns a digest of all input that determines the bytes of frame k. Costs far less than frame().
  /// @throws core::Error
  virtual core::Digest digest(std::int64_t k) = 0;
};

}  // namespace poinsot::job
