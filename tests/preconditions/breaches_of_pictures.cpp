// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <limits>

#include "compare/film_diff.h"
#include "core/file_batch.h"
#include "describe/report.h"
#include "draw/camera.h"
#include "figure/figure.h"
#include "job/still_batch.h"
#include "output/film.h"
#include "output/frame_pattern.h"
#include "output/video_segment.h"
#include "physics/driven_motion.h"
#include "preconditions/breaches.h"
#include "process/interrupt.h"
#include "reference/grade.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "stage/picture_layout.h"
#include "stage/plot/plot_figure.h"
#include "stage/stability_map.h"
#include "stage/stage.h"
#include "stage/sweep_stage.h"
#include "stage/type/matrix_text.h"
#include "stage/type/written_number.h"
#include "support/scratch_folder.h"
#include "text/coverage.h"

namespace poinsot {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<Breach> ofDrawAndText() {
  const draw::Camera camera = draw::lookAt({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.5f, {64, 64});
  return {
      {"draw/camera.h", "eye and target differ",
       [] {
         draw::lookAt({1, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, {9, 9});
       }},
      {"draw/camera.h", "up is not along the view",
       [] {
         draw::lookAt({0, 5, 0}, {0, 0, 0}, {0, 1, 0}, 1, {9, 9});
       }},
      {"draw/camera.h", "depthOf(camera, target_V) > 0",
       [=] {
         orthographic(camera, {0, 0, 6});
       }},
      {"draw/camera.h", "depthOf(...) > 0",
       [=] {
         project(camera, {0, 0, 5});
       }},
      {"text/coverage.h", "size_px in (0, 4000]", [] { text::rasterize({}, 0, 0, 0); }},
      {"text/coverage.h", "outline_px in [0, 200]", [] { text::rasterize({}, 9, 0, 0, 201); }},
      {"text/coverage.h", "origin within 10^6", [] { text::rasterize({}, 9, kNaN, 0); }},
  };
}

scene::Scene sceneWith(const std::string& more = "") {
  return scene::parseScene("[body]\nprincipal_moments = [2, 3, 4]\n[motion]\nomega_body = [1, 0.5, 1.6]\n" + more,
                           "sample.toml");
}

int indexOf(std::string_view quantity) {
  const auto all = scene::stateQuantities();
  return static_cast<int>(std::ranges::find(all, quantity, &scene::StateQuantity::name) - all.begin());
}

std::vector<Breach> ofStage() {
  using namespace stage;
  const auto compose = [](const Moment& moment, glm::ivec2 size_px) {
    Stage(sceneWith()).compose(moment, size_px);
  };
  const auto plotOf = [](const std::vector<int>& quantities, std::optional<int> x) {
    scene::Plot plot;
    plot.quantities = quantities;
    plot.x = x;
    PlotFigure(sceneWith(), plot, drawnMotion(sceneWith()));
  };
  const scene::GridPlace wide{.columns = 2}, second{.column = 1};
  const PlotRanges portrait{{}, QuantityRange{}};
  return {
      {"stage/composer.h", "the film time is finite",
       [=] {
         compose({kNaN, true}, {96, 54});
       }},
      {"stage/composer.h", "the film time is finite",
       [=] {
         compose(INFINITY, {96, 54});
       }},
      {"stage/composer.h", "not negative",
       [=] {
         compose({-1, true}, {96, 54});
       }},
      {"stage/composer.h", "width, height > 0",
       [=] {
         compose(0, {0, 0});
       }},
      {"stage/composer.h", "width, height > 0",
       [=] {
         compose(0, {96, -1});
       }},
      {"stage/stage.h", "mostMetre_px is empty or has one for each view",
       [] {
         Stage(sceneWith()).compose(0, {96, 54}, screenSizing({96, 54}), std::vector<double>{1, 2});
       }},
      {"stage/stage.h", "as Composer::compose()",
       [] {
         Stage(sceneWith()).compose(-1, {96, 54}, screenSizing({96, 54}), {});
       }},
      {"stage/picture_layout.h", "`places` is not empty", [] { PictureLayout({}); }},
      {"stage/picture_layout.h", "no two places overlap",
       [=] {
         PictureLayout({wide, second});
       }},
      {"stage/plot/plot_figure.h", "or neither plot has one", [=] { joined(PlotRanges{}, portrait); }},
      {"stage/plot/plot_figure.h", "quantities are of one unit",
       [=] {
         plotOf({indexOf("omega_1"), indexOf("T")}, {});
       }},
      {"stage/plot/plot_figure.h", "a phase portrait has one quantity",
       [=] {
         plotOf({indexOf("omega_1"), indexOf("omega_2")}, indexOf("omega_3"));
       }},
      {"stage/plot/plot_figure.h", "quantities are of one unit", [=] { plotOf({}, {}); }},
      {"stage/type/matrix_text.h", "the note has a matrix", [] { stage::matrixText({}, sceneWith()); }},
      {"stage/type/written_number.h", "`asked` is empty or a unit",
       [] { writtenUnit(scene::QuantityUnit::kRadianPerSecond, 1, "kg"); }},
  };
}

/// Calls `make` with a renderer and a picture of 64x48 pixels.
template <typename Make>
void render(Make make) {
  const auto context = gl::openContext(gl::Backend::kAuto);
  render::Renderer renderer(*context);
  draw::Picture picture = stage::Stage(sceneWith()).compose(0, {64, 48});
  make(renderer, picture);
}

std::vector<Breach> ofRender() {
  using render::Renderer;
  return {
      {"render/renderer.h", "the context is current on this thread",
       [] {
         render([](Renderer& r, draw::Picture& p) {
           const auto inner = gl::openContext(gl::Backend::kAuto);
           r.render(p);
         });
       }},
      {"render/renderer.h", "the list was composed for this size",
       [] { render([](Renderer& r, draw::Picture& p) {
              r.render(p.panels[0].list, {65, 48});
            }); }},
      {"draw/picture.h", "made for the panel's size",
       [] {
         render([](Renderer& r, draw::Picture& p) {
           p.panels[0].list.camera.size_px.x = 1e4f;
           r.render(p);
         });
       }},
      {"render/renderer.h", "panels lie within the picture",
       [] {
         render([](Renderer& r, draw::Picture& p) {
           p.panels[0].origin_px.x = 1;
           r.render(p);
         });
       }},
      {"render/renderer.h", "points of areas and strokes are finite",
       [] {
         render([](Renderer& r, draw::Picture& p) {
           p.areas.push_back({{{0, 0}, {9, 0}, {0, std::numeric_limits<float>::infinity()}}});
           r.render(p);
         });
       }},
  };
}

/// Calls `write` with the picture and a writer of 64x48 pixels whose first frame is 3.
template <typename Write>
void film(image::AnyImage picture, Write write) {
  const ScratchFolder folder;
  output::VideoSegmentWriter writer(folder / "film.mp4", {64, 48}, {25, 1}, {}, 3);
  write(writer, image::Frame(picture));
}

std::vector<Breach> ofOutput() {
  using core::FileBatch;
  using Writer = output::VideoSegmentWriter;
  const auto firstAs = [](std::int64_t k) {
    return [k](Writer& writer, const image::Frame& frame) { writer.write(frame, k); };
  };
  const auto batch = [](auto use) {
    const ScratchFolder folder;
    FileBatch files;
    use(files, folder);
  };
  const image::Image whole({64, 48}, 3), other({32, 48}, 3);
  return {
      {"figure/figure.h", "one of the three endings", [=] { figure::writeFigure("a.bmp", {}, whole, {}); }},
      {"figure/figure.h", "in the picture's size", [=] { figure::writeFigure("a.svg", {}, whole, {}); }},
      {"core/file_batch.h", "there is one",
       [=] { batch([](FileBatch& files, const ScratchFolder& f) { files.writeBeside(f / "a", "a"); }); }},
      {"core/file_batch.h", "there is one",
       [=] { batch([](FileBatch& files, const ScratchFolder& f) { files.removeBeside(f / "a"); }); }},
      {"core/file_batch.h", "no other file is appended to",
       [=] {
         batch([](FileBatch& files, const ScratchFolder& f) {
           files.append(f / "a", "a");
           files.append(f / "b", "b");
         });
       }},
      {"output/film.h", "an MP4",
       [] {
         output::FilmStream([](auto) { return 0; }, {.container = output::FilmContainer::kWebm, .fps = {25, 1}});
       }},
      {"output/frame_pattern.h", "k >= 0", [] { output::FramePattern("{frame}.png").path(-1); }},
      {"output/frame_sink.h", "8 bits a sample",
       [=] {
         film(image::DeepImage({64, 48}, 3), firstAs(3));
       }},
      {"output/video_segment.h", "8 bits a sample",
       [=] {
         film(image::DeepImage({64, 48}, 3), firstAs(3));
       }},
      {"output/video_segment.h", "the constructor's size", [=] { film(other, firstAs(3)); }},
      {"output/video_segment.h", "k follows the last one", [=] { film(whole, firstAs(4)); }},
      {"output/video_segment.h", "at least one frame",
       [=] { film(whole, [](Writer& writer, const image::Frame&) { writer.finish(); }); }},
  };
}

std::vector<Breach> ofResults() {
  using namespace compare;
  using namespace describe;
  using namespace job;
  using namespace reference;
  const std::vector<double> three = {1, 2, 3}, two = {1, 2};
  return {
      {"compare/film_diff.h", "there is at least one frame",
       [] {
         FilmDiff{"", {25, 1}, FilmTimes(1), {}}.worst();
       }},
      {"compare/film_diff.h", "there is at least one frame",
       [] {
         FilmDiff{"", {25, 1}, FilmTimes(1), {}}.first();
       }},
      {"compare/film_times.h", "frame < frames()", [] { FilmTimes(1).start_s(0); }},
      {"reference/grade.h", "the key exists", [] { Grade().quantity("colour"); }},
      {"reference/grade_drift.h", "as many times as errors", [=] { findDrift(three, two); }},
      {"reference/grade_known_motion.h", "knows(t_s)",
       [] {
         const physics::DrivenMotion motion(physics::PrincipalMoments(1, 2, 3), {0, 0, 1},
                                            Eigen::Quaterniond::Identity(), {}, {0, 1});
         KnownMotion(motion, {0, 1}).at(2);
       }},
      {"reference/grade_table.h", "as many",
       [=] {
         TrajectoryTable({0, 1, 2, 3, 4}, "a.csv").append(two, {});
       }},
      {"describe/report.h", "digits from 1",
       [] {
         reportTable({"a", {{"b", {{"c", "d", 1.0, "", ""}}}}}, 0);
       }},
      {"describe/report.h", "to kAllDigits",
       [] {
         reportTable({"a", {{"b", {{"c", "d", 1.0, "", ""}}}}}, 18);
       }},
      {"process/interrupt.h", "seconds > 0", [] { process::limitTime(0, 2); }},
      {"job/still_batch.h", "of one frame",
       [] {
         RenderRequest request;
         request.frames = {0, 2};
         makeStills({request}, 1, {});
       }},
  };
}

}  // namespace

std::vector<Breach> breachesOfPictures() {
  std::vector<Breach> all;
  for (const auto& part : {ofDrawAndText(), ofStage(), ofRender(), ofOutput(), ofResults()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace poinsot
