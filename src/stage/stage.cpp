// SPDX-License-Identifier: Apache-2.0
#include "stage/stage.h"

#include <algorithm>
#include <cmath>

#include "stage/lettering.h"
#include "stage/picture_motion.h"

namespace poinsot::stage {
namespace {

// Type in a small panel shrinks less than the panel, so that it stays legible from afar: this power of its share
// of the picture. In half a picture to 87 %, in a quarter to 76 %.
constexpr double kTypeShrinks = 0.2;
// Bodies of panels that could differ more than this in size are not drawn alike: the smaller would look lost.
constexpr double kMostUnlike = 1.6;
// Of the picture's height: a title that reaches farther down, as on a small print, would run into what is shown.
constexpr double kTallTitle = 0.16;

double typeShare(glm::ivec2 panel_px, glm::ivec2 picture_px) {
  const auto area = [](glm::ivec2 size) { return static_cast<double>(size.x) * static_cast<double>(size.y); };
  return std::pow(area(panel_px) / area(picture_px), kTypeShrinks);
}

scene::Scene viewOf(const scene::Scene& scene, const scene::View& view) {
  scene::Scene seen = scene;
  seen.camera = view.camera;
  seen.show = view.show;
  return seen;
}

/// Room above the panel's picture for what stands over it: its heading, or the title of the whole picture.
double topMargin(const PanelFrame& frame, bool titled) {
  if (frame.heading_px > 0) return std::min(frame.heading_px / frame.size_px.y + 0.02, 0.4);
  return titled ? 0.1 : Margins().top;  // the title's lines stand over the picture, not in it
}

/// The body is as large in all panels where it can be.
void shareScale(const std::vector<ViewStage>& views, std::vector<PanelFrame>& frames) {
  std::vector<double> metre_px;
  for (std::size_t i = 0; i < views.size(); ++i) metre_px.push_back(views[i].metre_px(frames[i]));
  const auto [least, most] = std::ranges::minmax(metre_px);
  if (!(most <= kMostUnlike * least)) return;
  for (std::size_t i = 0; i < views.size(); ++i) frames[i].mostUnit_px = least / views[i].bodyScale();
}

}  // namespace

Stage::Stage(scene::Scene scene)
    : scene_(std::move(scene)), colors_(palette(scene_.style.theme)), layout_(scene_.views) {
  const auto motion = drawnMotion(scene_);
  for (const scene::View& view : scene_.views) views_.emplace_back(viewOf(scene_, view), motion);
}

draw::Picture Stage::compose(double filmTime_s, glm::ivec2 size_px) const {
  return compose(filmTime_s, size_px, screenSizing(size_px));
}

draw::Picture Stage::compose(double filmTime_s, glm::ivec2 size_px, const Sizing& sizing) const {
  draw::Picture picture;
  picture.size_px = size_px;
  picture.background = colors_.paper;
  const double title_px = addTitle(picture, scene_, sizing, colors_);
  const std::vector<Cell> cells = layout_.cells(size_px, title_px);
  const std::vector<PanelFrame> frames = framesOf(picture, cells, sizing, title_px);
  for (std::size_t i = 0; i < views_.size(); ++i)
    picture.panels.push_back({cells[i].origin_px, views_[i].compose(filmTime_s, frames[i])});
  layout_.addRules(picture, cells, sizing.line_px, colors_);
  return picture;
}

std::vector<PanelFrame> Stage::framesOf(draw::Picture& picture, const std::vector<Cell>& cells,
                                        const Sizing& sizing, double title_px) const {
  const bool titled = views_.size() == 1 && !scene_.show.title.empty();
  std::vector<PanelFrame> frames;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    PanelFrame& frame = frames.emplace_back();
    frame.size_px = cells[i].size_px;
    const double share = typeShare(cells[i].size_px, picture.size_px);
    frame.type_px = share * sizing.type_px;
    frame.line_px = share * sizing.line_px;
    frame.least_px = sizing.least_px;
    const Sizing panel{frame.type_px, frame.line_px, frame.least_px};
    frame.heading_px =
        addHeading(picture, cells[i], scene_.views[i], typeScaled(panel, scene_.style.textSize), colors_);
    if (titled && title_px > kTallTitle * frame.size_px.y) frame.heading_px = title_px;
    frame.margins.top = topMargin(frame, titled);
  }
  if (frames.size() > 1) shareScale(views_, frames);
  return frames;
}

}  // namespace poinsot::stage
