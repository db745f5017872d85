// SPDX-License-Identifier: Apache-2.0
#include "app/segment_sink.h"

#include <utility>

#include "output/png_sequence.h"
#include "output/video_segment.h"

namespace poinsot::app {
namespace {

/// A segment of film, which times itself.
class FilmSegment : public output::FrameSink {
 public:
  FilmSegment(const std::filesystem::path& file, const scene::Scene& scene, std::int64_t first,
              EncodingTimes& times)
      : writer_(file, {scene.output.width, scene.output.height}, scene.time.fps, scene.output.crf, first),
        times_(times) {}

  void write(const image::Image& picture, std::int64_t k) override { writer_.write(picture, k); }

  void finish() override {
    writer_.finish();
    times_.convert_s += writer_.spent().convert_s;
    times_.encode_s += writer_.spent().encode_s;
  }

 private:
  output::VideoSegmentWriter writer_;
  EncodingTimes& times_;
};

/// The one file of a single picture.
class SinglePicture : public output::FrameSink {
 public:
  explicit SinglePicture(std::filesystem::path target) : target_(std::move(target)) {}
  void write(const image::Image& picture, std::int64_t) override { output::writePng(target_, picture); }
  void finish() override {}

 private:
  std::filesystem::path target_;
};

/// Pictures, timed from outside.
class TimedPictures : public output::FrameSink {
 public:
  TimedPictures(std::unique_ptr<output::FrameSink> sink, EncodingTimes& times)
      : sink_(std::move(sink)), times_(times) {}

  void write(const image::Image& picture, std::int64_t k) override {
    timed([&] { sink_->write(picture, k); });
  }
  void finish() override {
    timed([&] { sink_->finish(); });
  }

 private:
  template <class Step>
  void timed(Step step) {
    const double before_s = processCpu_s();
    step();
    times_.encode_s += processCpu_s() - before_s;
  }

  std::unique_ptr<output::FrameSink> sink_;
  EncodingTimes& times_;
};

std::unique_ptr<output::FrameSink> pictureSink(const OutputTarget& target) {
  if (target.kind == OutputKind::kPicture) return std::make_unique<SinglePicture>(target.path);
  return std::make_unique<output::PngSequence>(output::FramePattern(target.path.string()));
}

}  // namespace

SinkMaker sinkMaker(const WorkerJob& job, const scene::Scene& scene, EncodingTimes& times) {
  return [&job, &scene, &times](const FrameRange& segment) -> std::unique_ptr<output::FrameSink> {
    if (job.target.kind != OutputKind::kFilm)
      return std::make_unique<TimedPictures>(pictureSink(job.target), times);
    return std::make_unique<FilmSegment>(segmentFile(job.workFolder, segment), scene, segment.first, times);
  };
}

}  // namespace poinsot::app
