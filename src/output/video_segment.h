// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "core/rational.h"
#include "core/step_times.h"
#include "output/film_format.h"
#include "output/frame_sink.h"

namespace poinsot::output {

/// Writes one segment of a film: a small file with consecutive frames, encoded separately. The file begins with a
/// key frame and refers to no other file. A film (film.h) is joined from segments with equal settings; its bytes
/// do not depend on which worker wrote which segment. Stream and container declare BT.709, limited range.
class VideoSegmentWriter : public FrameSink {
 public:
  /// @param firstFrame  number k of the first frame; later frames follow without gaps.
  /// @param steps  receives the time; may be null.
  /// @throws core::Error(kUsage) as checkFormat(), or for a rate below 1/60000 in an MP4; kEncode; kIo.
  VideoSegmentWriter(const std::filesystem::path& target, image::PixelSize size, const core::Rational& fps,
                     const FilmFormat& format, std::int64_t firstFrame, core::StepLedger* steps = nullptr);
  ~VideoSegmentWriter() override;

  /// Encodes a frame. @pre the constructor's size, 8 bits a sample; k follows the last one.
  /// @warning All frames that have a picture number (image/frame.h) must come from the same series of pictures,
  ///   because only their changed parts are converted.
  void write(const image::Frame& frame, std::int64_t k) override;
  /// @pre at least one frame was written.
  void finish() override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
  image::PixelSize size_;
  std::int64_t firstFrame_ = 0, nextFrame_ = 0;
  std::uint64_t held_ = 0;  // number of the picture that the encoder's frame contains
};

}  // namespace poinsot::output
