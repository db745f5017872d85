// SPDX-License-Identifier: Apache-2.0
#include "output/video_segment.h"

#include "core/expect.h"
#include "output/ffmpeg_container.h"
#include "output/ffmpeg_encoder.h"
#include "output/film_frame.h"

namespace poinsot::output {
struct VideoSegmentWriter::Parts {
  Parts(const std::filesystem::path& target, image::PixelSize size, const core::Rational& fps,
        const FilmFormat& format, core::StepLedger* ledger)
      : steps(ledger),
        encoder(size, fps, format),
        file(target, segmentFormat(format.container), *parametersOf(encoder.context()), fps, Index::kAtEnd, {}) {}

  core::StepLedger* steps;
  FilmEncoder encoder;
  TrackWriter file;
  FilmEncoder::PacketSink toFile = [this](AVPacket& packet) {
    const core::StepScope timing(steps, core::Step::kWrite);
    file.write(packet, packet.pts);
  };
};

VideoSegmentWriter::VideoSegmentWriter(const std::filesystem::path& target, image::PixelSize size,
                                       const core::Rational& fps, const FilmFormat& format,
                                       std::int64_t firstFrame, core::StepLedger* steps)
    : parts_(std::make_unique<Parts>(target, size, fps, format, steps)),
      size_(size),
      firstFrame_(firstFrame),
      nextFrame_(firstFrame) {}

VideoSegmentWriter::~VideoSegmentWriter() = default;

void VideoSegmentWriter::write(const image::Frame& frame, std::int64_t k) {
  POINSOT_EXPECT(std::holds_alternative<image::Image>(frame.picture));
  const auto& picture = std::get<image::Image>(frame.picture);
  POINSOT_EXPECT(k == nextFrame_);
  POINSOT_EXPECT(picture.size == size_);
  ++nextFrame_;
  {
    const core::StepScope timing(parts_->steps, core::Step::kConvert);
    if (frame.number > 1 && frame.number == held_ + 1)
      fillFrame(parts_->encoder.frame(), picture, frame.changed);
    else
      fillFrame(parts_->encoder.frame(), picture);
    held_ = frame.number;
  }
  const core::StepScope timing(parts_->steps, core::Step::kEncode);
  parts_->encoder.encode(parts_->toFile);
}

void VideoSegmentWriter::finish() {
  POINSOT_EXPECT(nextFrame_ > firstFrame_);
  const core::StepScope timing(parts_->steps, core::Step::kEncode);
  parts_->encoder.drain(parts_->toFile);
  const core::StepScope writing(parts_->steps, core::Step::kWrite);
  parts_->file.finish().commit();
}

}  // namespace poinsot::output
