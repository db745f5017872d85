// SPDX-License-Identifier: Apache-2.0
#include "output/video_segment.h"

#include <ctime>

#include "core/expect.h"
#include "output/ffmpeg_encoder.h"
#include "output/ffmpeg_mp4.h"

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

CodecParametersPtr parametersOf(const AVCodecContext& context) {
  auto parameters = checkAlloc(CodecParametersPtr(avcodec_parameters_alloc()));
  checkAv(avcodec_parameters_from_context(parameters.get(), &context), "describing the stream");
  return parameters;
}

}  // namespace

struct VideoSegmentWriter::Parts {
  Parts(const std::filesystem::path& target, image::PixelSize size, const core::Rational& fps, double crf)
      : encoder(size, fps, crf),
        file(target, *parametersOf(encoder.context()), frameClock(fps), Mp4Writer::Index::kAtEnd, {}) {}

  H264Encoder encoder;
  Mp4Writer file;
  H264Encoder::PacketSink toFile = [this](AVPacket& packet) { file.write(packet, packet.pts); };
};

VideoSegmentWriter::VideoSegmentWriter(const std::filesystem::path& target, image::PixelSize size,
                                       const core::Rational& fps, double crf, std::int64_t firstFrame)
    : parts_(std::make_unique<Parts>(target, size, fps, crf)), size_(size), nextFrame_(firstFrame) {}

VideoSegmentWriter::~VideoSegmentWriter() = default;

void VideoSegmentWriter::write(const image::Image& picture, std::int64_t k) {
  POINSOT_EXPECT(k == nextFrame_);
  POINSOT_EXPECT(picture.size == size_);
  ++nextFrame_;
  {
    const Stopwatch watch(spent_.convert_s);
    convertToYuv420(picture, parts_->encoder.planes());
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
