// SPDX-License-Identifier: Apache-2.0
#include "app/segment_sink.h"

#include <utility>

#include "app/film_choice.h"
#include "app/job_file.h"
#include "app/picture_words.h"
#include "output/figure.h"
#include "output/png_sequence.h"
#include "output/video_segment.h"

namespace poinsot::app {
namespace {

/// A segment of film, which times itself.
class FilmSegment : public output::FrameSink {
 public:
  FilmSegment(const std::filesystem::path& file, const scene::Scene& scene, const output::FilmFormat& format,
              std::int64_t first, EncodingTimes& times)
      : writer_(file, {scene.output.width, scene.output.height}, scene.time.fps, format, first), times_(times) {}

  void write(const image::AnyImage& picture, std::int64_t k) override { writer_.write(picture, k); }

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
  SinglePicture(std::filesystem::path target, std::vector<image::PngText> texts, double dpi,
                output::FrameDigestText digestOf)
      : target_(std::move(target)), texts_(std::move(texts)), dpi_(dpi), digestOf_(std::move(digestOf)) {}
  void write(const image::AnyImage& picture, std::int64_t k) override {
    std::vector<image::PngText> texts = texts_;
    texts.push_back(output::digestText(digestOf_(k)));
    output::writePng(target_, picture, texts, dpi_);
  }
  void finish() override {}

 private:
  std::filesystem::path target_;
  std::vector<image::PngText> texts_;
  double dpi_;
  output::FrameDigestText digestOf_;
};

/// A picture that is more than its pixels.
class SingleFigure : public output::FrameSink {
 public:
  SingleFigure(std::filesystem::path target, output::FigureOptions options, const SceneFrames& frames)
      : target_(std::move(target)), options_(std::move(options)), frames_(frames) {}
  void write(const image::AnyImage& imagePart, std::int64_t) override {
    output::writeFigure(target_, frames_.picture(), std::get<image::Image>(imagePart), options_);
  }
  void finish() override {}

 private:
  std::filesystem::path target_;
  output::FigureOptions options_;
  const SceneFrames& frames_;
};

/// Pictures, timed from outside.
class TimedPictures : public output::FrameSink {
 public:
  TimedPictures(std::unique_ptr<output::FrameSink> sink, EncodingTimes& times)
      : sink_(std::move(sink)), times_(times) {}

  bool has(std::int64_t k) const override { return sink_->has(k); }
  void write(const image::AnyImage& picture, std::int64_t k) override {
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

std::unique_ptr<output::FrameSink> pictureSink(const WorkerJob& job, const scene::Scene& scene,
                                               SceneFrames& frames) {
  const auto& path = job.target.path;
  const auto [title, description] = pictureWords(scene);
  const PrintSize print = job.form.print.value_or(PrintSize{});
  if (job.target.kind == OutputKind::kFigure)
    return std::make_unique<SingleFigure>(path, output::FigureOptions{print.width_mm, title, description}, frames);
  auto texts = output::pngTexts(title, description);
  auto digestOf = [&frames](std::int64_t k) { return core::toHex(frames.digest(k)); };
  if (job.target.kind == OutputKind::kPicture) texts.push_back({"Renderer", frames.renderer()});
  if (job.target.kind == OutputKind::kPicture)
    return std::make_unique<SinglePicture>(path, std::move(texts), job.form.print ? print.dpi : 0, digestOf);
  // What is said of the whole film is not said by its frames: they stay as they are when it changes.
  return std::make_unique<output::PngSequence>(output::FramePattern(path.string()),
                                               output::SequenceOptions{{}, digestOf, job.resume, job.workFolder});
}

}  // namespace

SinkMaker sinkMaker(const WorkerJob& job, const scene::Scene& scene, SceneFrames& frames, EncodingTimes& times) {
  return [&](const FrameRange& segment) -> std::unique_ptr<output::FrameSink> {
    if (job.target.kind != OutputKind::kFilm)
      return std::make_unique<TimedPictures>(pictureSink(job, scene, frames), times);
    const output::FilmFormat format = filmFormat(job.target, scene.output, job.form);
    return std::make_unique<FilmSegment>(segmentFile(job.workFolder, format.container, segment), scene, format,
                                         segment.first, times);
  };
}

}  // namespace poinsot::app
