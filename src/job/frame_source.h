// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/sha256.h"
#include "image/frame.h"

namespace poinsot::job {

/// Makes frames; each is a function of its number alone, so any order gives the same pictures.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// Good until the next frame is asked for. @throws core::Error
  virtual image::Frame frame(std::int64_t k) = 0;
  /// Of all that decides the frame's bytes; far cheaper than the frame. @throws core::Error
  virtual core::Digest digest(std::int64_t k) = 0;
};

}  // namespace poinsot::job
