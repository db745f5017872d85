// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "core/rational.h"
#include "output/frame_sink.h"

namespace poinsot::output {

/// CPU seconds of the calling thread.
struct EncodingSpent {
  double convert_s = 0;  ///< RGB to YUV
  double encode_s = 0;   ///< x264, the container and the disk
};

/// A piece of film: consecutive frames, encoded by an encoder of its own into a small MP4 that begins with a key
/// frame and refers to nothing outside. Segments made with the same settings join without re-encoding (film.h), so
/// who made which segment does not change a byte of the film. H.264 High, 4:2:0, BT.709 limited range, said both
/// in the stream and in the container.
class VideoSegmentWriter : public FrameSink {
 public:
  /// @param firstFrame  the k of the first write; the next ones follow without gaps.
  /// @throws core::Error(kUsage) for odd sizes, crf out of 0..51 or a rate below 1/60000; kEncode; kIo.
  VideoSegmentWriter(const std::filesystem::path& target, image::PixelSize size, const core::Rational& fps,
                     double crf, std::int64_t firstFrame);
  ~VideoSegmentWriter() override;

  /// @pre the constructor's size.
  void write(const image::Image& picture, std::int64_t k) override;
  /// @pre at least one frame was written.
  void finish() override;

  EncodingSpent spent() const { return spent_; }

 private:
  struct Parts;  // keeps libav's headers out of this one
  std::unique_ptr<Parts> parts_;
  image::PixelSize size_;
  std::int64_t nextFrame_ = 0;
  EncodingSpent spent_;
};

}  // namespace poinsot::output
