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

/// A piece of film: consecutive frames, encoded by an encoder of its own into a small file that begins with a key
/// frame and refers to nothing outside. Segments made with the same settings make the film (film.h), so who made
/// which does not change a byte of it. BT.709, limited range, said both in the stream and in the container.
class VideoSegmentWriter : public FrameSink {
 public:
  /// @param firstFrame  the k of the first write; the next ones follow without gaps.
  /// @param steps  where the time is entered.
  /// @throws core::Error(kUsage) as checkFormat(), or for a rate below 1/60000 in an MP4; kEncode; kIo.
  VideoSegmentWriter(const std::filesystem::path& target, image::PixelSize size, const core::Rational& fps,
                     const FilmFormat& format, std::int64_t firstFrame, core::StepLedger* steps = nullptr);
  ~VideoSegmentWriter() override;

  /// @warning All numbered frames must be of one row (image/frame.h): what has not changed is not read again.
  /// @pre the constructor's size, 8 bits a sample; k follows the last one.
  void write(const image::Frame& frame, std::int64_t k) override;
  /// @pre at least one frame was written.
  void finish() override;

 private:
  struct Parts;  // keeps libav's headers out of this one
  std::unique_ptr<Parts> parts_;
  image::PixelSize size_;
  std::int64_t firstFrame_ = 0, nextFrame_ = 0;
  std::uint64_t held_ = 0;  // number of the picture that the encoder's frame holds
};

}  // namespace poinsot::output
