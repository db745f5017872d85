// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/sha256.h"
#include "image/image.h"

namespace poinsot::app {

/// CPU seconds spent on the frames so far, by step.
struct FrameTimes {
  double compose_s = 0;  ///< simulate and compose the draw list
  double render_s = 0;
  double read_s = 0;
  double text_s = 0;

  double sum_s() const { return compose_s + render_s + read_s + text_s; }
  FrameTimes& operator+=(const FrameTimes& other);
  FrameTimes& operator-=(const FrameTimes& other);
};

/// Makes frames; each is a function of its number alone, so any order gives the same pictures.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// @throws core::Error
  virtual image::AnyImage frame(std::int64_t k) = 0;
  /// Of all that decides the frame's bytes; far cheaper than the frame. @throws core::Error
  virtual core::Digest digest(std::int64_t k) = 0;
  virtual FrameTimes times() const { return {}; }
};

}  // namespace poinsot::app
