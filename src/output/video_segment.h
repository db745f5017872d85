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

/// Writer of one segment of a film: consecutive frames in a small file, from an encoder of their own. The file
/// begins with a key frame and refers to nothing outside. Segments made with the same settings make the film
/// (film.h), so that not a byte depends on which worker made which segment. Stream and container both declare
/// BT.709, limited range.
class VideoSegmentWriter : public FrameSink {
 public:
  /// @param firstFrame  the k of the first write(); later frames follow without gaps.
  /// @param steps  receives the time; may be null.
  /// @throws core::Error(kUsage) as checkFormat(), or for a rate below 1/60000 in an MP4; kEncode; kIo.
  VideoSegmentWriter(const std::filesystem::path& target, image::PixelSize size, const core::Rational& fps,
                     const FilmFormat& format, std::int64_t firstFrame, core::StepLedger* steps = nullptr);
  ~VideoSegmentWriter() override;

  /// @warning All numbered frames must come from one row of pictures (image/frame.h), because only the parts that
  /// have changed are read again.
  /// @pre the constructor's size, 8 bits a sample; k follows the last one.
  void write(const image::Frame& frame, std::int64_t k) override;
  /// @pre at least one frame was written.
  void finish() override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
  image::PixelSize size_;
  std::int64_t firstFrame_ = 0, nextFrame_ = 0;
  std::uint64_t held_ = 0;  // number of the picture in the encoder's frame
};

}  // namespace poinsot::output
