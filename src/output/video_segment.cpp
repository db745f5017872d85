// SPDX-License-Identifier: Apache-2.0
#include "output/video_segment.h"

#include <ctime>

#include "core/expect.h"
#include "output/ffmpeg_container.h"
#include "output/ffmpeg_encoder.h"
#include "output/film_frame.h"

namespace poinsot::output {
namespace {

double threadCpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Adds the time until its end to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum_s) : sum_s_(sum_s), start_s_(threadCpu_s()) {}
  ~Stopwatch() { sum_s_ += threadCpu_s() - start_s_; }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& sum_s_;
  double start_s_;
};

}  // namespace

struct VideoSegmentWriter::Parts {
  Parts(const std::filesystem::path& target, image::PixelSize size, const core::Rational& fps,
        const FilmFormat& format)
      : encoder(size, fps, format),
        file(target, segmentFormat(format.container), *parametersOf(encoder.context()), fps, Index::kAtEnd, {}) {}

  FilmEncoder encoder;
  TrackWriter file;
  FilmEncoder::PacketSink toFile = [this](AVPacket& packet) { file.write(packet, packet.pts); };
};

VideoSegmentWriter::VideoSegmentWriter(const std::filesystem::path& target, image::PixelSize size,
                                       const core::Rational& fps, const FilmFormat& format,
                                       std::int64_t firstFrame)
    : parts_(std::make_unique<Parts>(target, size, fps, format)), size_(size), nextFrame_(firstFrame) {}

VideoSegmentWriter::~VideoSegmentWriter() = default;

void VideoSegmentWriter::write(const image::AnyImage& any, std::int64_t k) {
  const auto& picture = std::get<image::Image>(any);
  POINSOT_EXPECT(k == nextFrame_);
  POINSOT_EXPECT(picture.size == size_);
  ++nextFrame_;
  {
    const Stopwatch watch(spent_.convert_s);
    fillFrame(parts_->encoder.frame(), picture);
  }
  const Stopwatch watch(spent_.encode_s);
  parts_->encoder.encode(parts_->toFile);
}

void VideoSegmentWriter::finish() {
  const Stopwatch watch(spent_.encode_s);
  parts_->encoder.drain(parts_->toFile);
  parts_->file.finish();
}

}  // namespace poinsot::output
