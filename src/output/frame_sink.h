// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "image/frame.h"

namespace poinsot::output {

/// Where frames go. Frames arrive in rising order of k, the frame number of the scene's film.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  /// Whether frame k is there already, as it would be written: then it need not come.
  virtual bool has(std::int64_t /*k*/) const { return false; }
  /// @pre 8 bits a sample, unless the sink takes more.
  /// @throws core::Error(kIo or kEncode).
  virtual void write(const image::Frame& frame, std::int64_t k) = 0;
  /// Makes everything written so far complete and durable. A sink destroyed without it leaves nothing incomplete
  /// behind.
  virtual void finish() = 0;
};

}  // namespace poinsot::output
