// SPDX-License-Identifier: Apache-2.0
#include "stage/stage.h"

#include <algorithm>
#include <cmath>

#include "core/expect.h"
#include "stage/picture_motion.h"
#include "stage/scales.h"
#include "stage/timed_motion.h"
#include "stage/type/note_rows.h"

namespace poinsot::stage {
namespace {

using scene::Spot;

// Exponent with which text shrinks: (area of the panel / area of the picture)^kTypeShrinks. Text shrinks less than
// its panel, so that it stays legible: to 87 % in half a picture, to 76 % in a quarter.
constexpr double kTypeShrinks = 0.2;
// Largest height of a title that may overlap the margin of the view, as a fraction of the picture's height. A
// taller title, as on a small print, would run into the drawing.
constexpr double kTallTitle = 0.16;
constexpr double kCornerMargin = 0.1;  // margin for text in a corner, which may overlap the view
constexpr double kAir = 0.02;          // gap between text and the drawing

double typeShare(glm::ivec2 panel_px, glm::ivec2 picture_px) {
  const auto area = [](glm::ivec2 size) { return static_cast<double>(size.x) * static_cast<double>(size.y); };
  return std::pow(area(panel_px) / area(picture_px), kTypeShrinks);
}

PixelBox boxOf(const Cell& cell) {
  const glm::dvec2 low(cell.origin_px), high = low + glm::dvec2(cell.size_px);
  return {low.x, low.y, high.x, high.y};
}

/// Adds a panel's heading. Returns the distance from the top of the panel to the bottom of the heading; 0 without
/// a heading.
double addHeading(draw::Picture& picture, const Cell& cell, const scene::View& view, const Sizing& type,
                  const Palette& colors) {
  const double edge_px = 0.5 * noteEdge_px(type);
  const double room_px = std::max(static_cast<double>(cell.size_px.x) - 2 * edge_px, 1.0);
  const NoteBlock block = headingBlock(view, type, room_px, colors);
  PixelBox box = boxOf(cell);
  box.top += edge_px;
  addBlocks(picture, {block}, {box});
  return block.rows.empty() ? 0 : edge_px + block.size_px().y;
}

scene::Scene viewOf(const scene::Scene& scene, const scene::View& view) {
  scene::Scene seen = scene;
  seen.camera = view.camera;
  seen.show = view.show;
  return seen;
}

std::vector<scene::GridPlace> placesOf(const scene::Scene& scene) {
  std::vector<scene::GridPlace> places;
  for (const scene::View& view : scene.views) places.push_back(view.place);
  for (const scene::Plot& plot : scene.plots) places.push_back(plot.place);
  return places;
}

/// Return the margin that a text block needs, as a fraction of the view's height or width: first for a block at
/// the middle of an edge, then for a block in a corner.
double besideEdge(double reach_px, double length_px) { return reach_px / length_px + kAir; }
double besideCorner(double reach_px, double length_px) {
  return reach_px > kCornerMargin * length_px ? kCornerMargin : Margins().top;
}

Margins marginsBeside(const std::vector<NoteBlock>& blocks, const std::vector<PixelBox>& boxes,
                      glm::dvec2 size_px) {
  Margins margins;
  const auto widen = [](double& margin, double to) { margin = std::max(margin, to); };
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const PixelBox& box = boxes[i];
    const double top = box.bottom, bottom = size_px.y - box.top;
    switch (blocks[i].at) {
      case Spot::kTop:
        widen(margins.top, besideEdge(top, size_px.y));
        break;
      case Spot::kBottom:
        widen(margins.bottom, besideEdge(bottom, size_px.y));
        break;
      case Spot::kLeft:
        widen(margins.left, besideEdge(box.right, size_px.x));
        break;
      case Spot::kRight:
        widen(margins.right, besideEdge(size_px.x - box.left, size_px.x));
        break;
      case Spot::kTopLeft:
      case Spot::kTopRight:
        widen(margins.top, besideCorner(top, size_px.y));
        break;
      case Spot::kBottomLeft:
      case Spot::kBottomRight:
        widen(margins.bottom, besideCorner(bottom, size_px.y));
        break;
      case Spot::kCentre:
        break;
    }
  }
  return margins;
}

void shareScale(const std::vector<ViewStage>& views, std::vector<PanelFrame>& frames) {
  std::vector<double> metres_px;
  for (std::size_t i = 0; i < views.size(); ++i) metres_px.push_back(views[i].metre_px(frames[i]));
  const double common_px = commonMetre_px(metres_px);
  for (std::size_t i = 0; i < views.size(); ++i) frames[i].mostUnit_px = common_px / views[i].bodyScale();
}

}  // namespace

Stage::Stage(const scene::Scene& scene, core::StepLedger* steps)
    : Stage(scene, timed(drawnMotion(scene), steps)) {}

Stage::Stage(scene::Scene scene, const std::shared_ptr<const physics::Motion>& motion, const FilmRanges& least)
    : scene_(std::move(scene)),
      colors_(palette(scene_.style)),
      layout_(placesOf(scene_)),
      readouts_(scene_, motion, colors_, least.readouts),
      presence_(scene_.timeline),
      captions_(scene_) {
  for (const scene::View& view : scene_.views) views_.emplace_back(viewOf(scene_, view), motion);
  POINSOT_EXPECT(least.plots.empty() || least.plots.size() == scene_.plots.size());
  for (std::size_t i = 0; i < scene_.plots.size(); ++i)
    plots_.emplace_back(scene_, scene_.plots[i], motion,
                        least.plots.empty() ? std::nullopt : std::optional(least.plots[i]));
}

draw::Picture Stage::compose(const Moment& moment, glm::ivec2 size_px, const Sizing& sizing) const {
  expectPicture(moment, size_px);
  requireWithin(moment, scene_.time.duration_s);
  return compose(moment, size_px, sizing, {});
}

draw::Picture Stage::compose(const Moment& moment, glm::ivec2 size_px, const Sizing& sizing,
                             std::span<const double> mostMetre_px) const {
  expectPicture(moment, size_px);
  POINSOT_EXPECT(mostMetre_px.empty() || mostMetre_px.size() == views_.size());
  draw::Picture picture;
  picture.size_px = size_px;
  picture.background = colors_.paper;
  const double filmTime_s = moment.filmTime_s;
  auto [writing, cells, frames] = arrange(picture, filmTime_s, sizing);
  for (std::size_t i = 0; i < mostMetre_px.size(); ++i)
    frames[i].mostUnit_px = std::min(frames[i].mostUnit_px, mostMetre_px[i] / views_[i].bodyScale());
  for (std::size_t i = 0; i < views_.size(); ++i)
    picture.panels.push_back({cells[i].origin_px, views_[i].compose(moment, frames[i])});
  addPlots(picture, std::span(cells).subspan(views_.size()), sizing, filmTime_s);
  layout_.addRules(picture, cells, sizing.line_px, colors_);
  addBlocks(picture, writing.blocks, writing.boxes);
  captions_.add(picture, moment, typeScaled(sizing, scene_.style.textSize), colors_);
  return picture;
}

Stage::Arrangement Stage::arrange(draw::Picture& picture, double filmTime_s, const Sizing& sizing) const {
  const glm::ivec2 stage_px = picture.size_px - glm::ivec2(0, strip_px(picture.size_px, sizing));
  Arrangement made;
  made.writing = writing(filmTime_s, stage_px, sizing);
  made.cells = layout_.cells(stage_px, writesOverView() ? NoteReach() : made.writing.reach);
  made.frames = framesOf(picture, made.cells, sizing, made.writing);
  return made;
}

int Stage::strip_px(glm::ivec2 size_px, const Sizing& sizing) const {
  const double wanted_px = captions_.height_px(size_px, typeScaled(sizing, scene_.style.textSize));
  return static_cast<int>(std::min(wanted_px, kMostStrip * size_px.y));
}

std::vector<double> Stage::metres_px(glm::ivec2 size_px, const Sizing& sizing) const {
  draw::Picture headings;
  headings.size_px = size_px;
  const Arrangement made = arrange(headings, 0, sizing);  // The arrangement is the same at all times.
  std::vector<double> metres_px;
  for (std::size_t i = 0; i < views_.size(); ++i) metres_px.push_back(views_[i].metre_px(made.frames[i]));
  return metres_px;
}

double Stage::flightScale() const {
  double least = views_.empty() ? 1 : views_.front().flightScale();
  for (const ViewStage& view : views_) least = std::min(least, view.flightScale());
  return least;
}

PictureWriting Stage::writing(double filmTime_s, glm::ivec2 size_px, const Sizing& sizing) const {
  const WrittenThings things{readouts_.at(filmTime_s), presence_.at("title", filmTime_s),
                             presence_.at("notes", filmTime_s), presence_.at("readouts", filmTime_s)};
  return pictureWriting(scene_, things, size_px, sizing, colors_);
}

// All plots use the text size that fits the smallest plot. Plots in one column have the same left and right
// margins, so that their time axes line up.
void Stage::addPlots(draw::Picture& picture, std::span<const Cell> cells, const Sizing& own,
                     double filmTime_s) const {
  double share = 1;
  for (std::size_t i = 0; i < plots_.size(); ++i) share = std::min(share, plots_[i].typeShare(cells[i], own));
  const Sizing sizing = inPart(own, share, 1);
  const auto inLine = [](const Cell& a, const Cell& b) {
    return a.origin_px.x == b.origin_px.x && a.size_px.x == b.size_px.x;
  };
  for (std::size_t i = 0; i < plots_.size(); ++i) {
    PlotSides least;
    for (std::size_t k = 0; k < plots_.size(); ++k) {
      if (!inLine(cells[i], cells[k])) continue;
      const PlotSides sides = plots_[k].sides(cells[k], sizing);
      least = {std::max(least.left, sides.left), std::max(least.right, sides.right)};
    }
    const std::size_t before = picture.strokes.size();
    plots_[i].add(picture, cells[i], sizing, filmTime_s, least);
    for (std::size_t k = before; k < picture.strokes.size(); ++k)
      picture.strokes[k].plot = static_cast<int>(i) + 1;
  }
}

std::vector<PanelFrame> Stage::framesOf(draw::Picture& picture, const std::vector<Cell>& cells,
                                        const Sizing& sizing, const PictureWriting& writing) const {
  std::vector<PanelFrame> frames;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    PanelFrame& frame = frames.emplace_back();
    frame.size_px = cells[i].size_px;
    const double share = typeShare(cells[i].size_px, picture.size_px);
    const Sizing part = inPart(sizing, share, share);
    frame.type_px = part.type_px;
    frame.line_px = part.line_px;
    frame.least_px = part.least_px;
    frame.arrowName = arrowNameOf(part);
    if (writesOverView()) makeRoomFor(writing, frame);
    const Sizing type = typeScaled(part, scene_.style.textSize);
    const double heading_px = addHeading(picture, cells[i], scene_.views[i], type, colors_);
    if (heading_px == 0) continue;
    frame.heading_px = heading_px;
    frame.margins.top = std::min(heading_px / frame.size_px.y + kAir, 0.4);
  }
  if (frames.size() > 1) shareScale(views_, frames);
  return frames;
}

void Stage::makeRoomFor(const PictureWriting& writing, PanelFrame& frame) const {
  frame.taken = writing.boxes;
  frame.margins = marginsBeside(writing.blocks, writing.boxes, frame.size_px);
  if (scene_.show.title.empty()) return;
  frame.margins.top = std::max(frame.margins.top, kCornerMargin);
  const double title_px = writing.boxes.front().bottom;  // the first block is the one at the top left
  if (title_px <= kTallTitle * frame.size_px.y) return;
  frame.heading_px = title_px;
  frame.margins.top = std::max(frame.margins.top, std::min(besideEdge(title_px, frame.size_px.y), 0.4));
}

}  // namespace poinsot::stage
