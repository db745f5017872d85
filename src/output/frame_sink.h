// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "image/frame.h"

namespace poinsot::output {

/// Receiver of a film's frames, such as a file. Frames arrive in rising order of k, their number in the scene's
/// film.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  /// Returns whether frame k exists, exactly as write() would write it. If so, the caller may skip the frame.
  virtual bool has(std::int64_t /*k*/) const { return false; }
  /// @pre 8 bits a sample, unless the sink takes more.
  /// @throws core::Error(kIo or kEncode).
  virtual void write(const image::Frame& frame, std::int64_t k) = 0;
  /// Makes everything written so far complete and durable. A sink that is destroyed without finish() leaves
  /// nothing incomplete behind.
  virtual void finish() = 0;
};

}  // namespace poinsot::output
