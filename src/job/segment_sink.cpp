// SPDX-License-Identifier: Apache-2.0
#include "job/segment_sink.h"

#include <fmt/format.h>

#include <utility>

#include "describe/picture_words.h"
#include "figure/figure.h"
#include "job/job_record.h"
#include "output/png_sequence.h"
#include "output/video_segment.h"
#include "request/output_target.h"

namespace poinsot::job {
namespace {

class SinglePicture : public output::FrameSink {
 public:
  SinglePicture(std::filesystem::path place, std::vector<image::PngText> texts, double dpi,
                output::FrameDigestText digestOf, core::StepLedger& steps)
      : place_(std::move(place)),
        texts_(std::move(texts)),
        dpi_(dpi),
        digestOf_(std::move(digestOf)),
        steps_(steps) {}
  void write(const image::Frame& frame, std::int64_t k) override {
    std::vector<image::PngText> texts = texts_;
    texts.push_back(output::digestText(digestOf_(k)));
    output::writePng(place_, frame.picture, texts, dpi_, &steps_, core::Durability::kRenamed);
  }
  void finish() override {}

 private:
  std::filesystem::path place_;
  std::vector<image::PngText> texts_;
  double dpi_;
  output::FrameDigestText digestOf_;
  core::StepLedger& steps_;
};

class SingleFigure : public output::FrameSink {
 public:
  SingleFigure(std::filesystem::path target, std::vector<std::filesystem::path> places,
               figure::FigureOptions options, const SceneFrames& frames, core::StepLedger& steps)
      : target_(std::move(target)),
        places_(std::move(places)),
        options_(std::move(options)),
        frames_(frames),
        steps_(steps) {}
  void write(const image::Frame& imagePart, std::int64_t) override {
    const core::StepScope timing(&steps_, core::Step::kEncode);
    const draw::Picture& picture = frames_.picture();
    figure::FigureOptions options = options_;
    options.width_mm *=
        static_cast<double>(picture.size_px.x) / frames_.size().width;  // a cropped picture is narrower
    const auto contents =
        figure::figureContents(target_, picture, std::get<image::Image>(imagePart.picture), options);
    for (std::size_t i = 0; i < places_.size(); ++i)
      core::writeFileAtomically(places_[i], contents[i], core::Durability::kRenamed);
  }
  void finish() override {}

 private:
  std::filesystem::path target_;
  std::vector<std::filesystem::path> places_;
  figure::FigureOptions options_;
  const SceneFrames& frames_;
  core::StepLedger& steps_;
};

std::unique_ptr<output::FrameSink> pictureSink(const WorkerTask& task, SceneFrames& frames,
                                               core::StepLedger& steps) {
  const RenderRequest& render = task.render;
  const auto& path = render.target.path;
  const auto [title, description] = describe::pictureWords(render.scene);
  const request::PrintSize print = render.form.print.value_or(request::PrintSize{});
  if (render.target.kind == request::OutputKind::kFigure)
    return std::make_unique<SingleFigure>(
        path, stagedFiles(task.workFolder, render.target),
        figure::FigureOptions{print.width_mm, title, description, render.form.svgText}, frames, steps);
  auto texts = figure::pngTexts(title, description);
  auto digestOf = [&frames](std::int64_t k) { return core::toHex(frames.digest(k)); };
  if (render.target.kind == request::OutputKind::kPicture) texts.push_back({"Renderer", frames.renderer()});
  if (render.target.kind == request::OutputKind::kPicture)
    return std::make_unique<SinglePicture>(stagedFiles(task.workFolder, render.target).front(), std::move(texts),
                                           render.form.print ? print.dpi : 0, digestOf, steps);
  // Omits title and description from frames, so that a new title does not make the frames stale.
  return std::make_unique<output::PngSequence>(
      output::FramePattern(path.string()),
      output::SequenceOptions{{}, digestOf, task.resumes(), task.workFolder, &steps});
}

}  // namespace

std::vector<std::filesystem::path> stagedFiles(const std::filesystem::path& workFolder,
                                               const request::OutputTarget& target) {
  std::vector<std::filesystem::path> places;
  for (std::size_t i = 0; i < figure::figureFiles(target.path).size(); ++i)
    places.push_back(workFolder / fmt::format("picture-{}.tmp", i));
  return places;
}

SinkMaker sinkMaker(const WorkerTask& task, SceneFrames& frames, core::StepLedger& steps) {
  return [&](const request::FrameRange& segment) -> std::unique_ptr<output::FrameSink> {
    const RenderRequest& render = task.render;
    if (render.target.kind != request::OutputKind::kFilm) return pictureSink(task, frames, steps);
    const scene::Scene& scene = render.scene.scene;
    const output::FilmFormat format = request::filmFormat(render.target, scene.output, render.form);
    return std::make_unique<output::VideoSegmentWriter>(segmentFile(task.workFolder, format.container, segment),
                                                        render.scene.size(), scene.time.fps, format, segment.first,
                                                        &steps);
  };
}

}  // namespace poinsot::job
