// SPDX-License-Identifier: Apache-2.0
#include "stage/stability_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/error.h"
#include "physics/binet.h"
#include "scene/motion/make_motion.h"
#include "stage/figures/globe.h"
#include "stage/plot/plot_frame.h"
#include "stage/type/picture_writing.h"
#include "text/math_setter.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr int kBands = 96;  // bands of colour; neighbours differ by less than the eye can see
constexpr int kSeparatrixPoints = 240;
constexpr double kDarkShare = 0.6;  // lines are white below this fraction of the scale, black above it
constexpr float kQuiet = 0.45f;

// Direction of the eye: from the middle axis, kAside_rad towards the axis of smallest moment and kAbove_rad
// towards the axis of largest moment. From there, the crossing of the separatrix is visible, and no axis points at
// the eye.
constexpr double kAside_rad = 0.66, kAbove_rad = 0.42;

constexpr double kAxis = 1.3;  // length of an axis, in radii of the sphere
// Lengths in em of the text, unless stated otherwise.
constexpr double kMapType = 0.034;  // size of the text, as a fraction of Sizing::type_px
constexpr double kBarGap = 3.2, kBarWidth = 1.0;
constexpr double kBarTick = 0.3, kBarTickGap = 0.35, kMapDigit = 0.67;
constexpr double kBarHeight = 1.7;
constexpr double kBarTip = 1.1, kOverBar = 0.9;  // height of the bar's pointed end; gap to the unit above
constexpr double kMark = 1.1, kBesideMark = 0.8;
constexpr double kMapNames = 1.1, kBesideAxis = 1.15, kBesideName = 2.1, kHead = 0.5, kHeadWidth = 0.22;
constexpr double kMapEdge = 0.6;  // margin at the picture's edges, as a fraction of the notes' margin
// Widths and radii, as multiples of the width of an ordinary line.
constexpr double kThin = 0.5, kOutline = 0.7, kRim = 1.1, kSeparatrix = 1.5, kMapAxisLine = 1.4, kAxisFoot = 1.6,
                 kStartDot = 3.2, kRing = 1.3;
constexpr double kLeastRim_px = 2;  // wide enough to cover the jagged edges of overlapping areas

[[noreturn]] void refuse(const std::string& why) { throw core::physicsError("stability map: " + why); }

Vector3d startingL_P(const scene::Scene& scene) {
  if (!scene.motion.isFree()) refuse("the body is not free: leave out gravity, torques and losses");
  if (!physics::separatrix(scene.body.axes.moments()))
    refuse("two principal moments are equal: such a body has no middle axis, and never flips");
  Vector3d m_P = scene.body.axes.moments().angularMomentum(scene::startOmega_P(scene));
  if (m_P.isZero(0)) refuse("the body is at rest, so L is zero: give a rotation");
  return m_P;
}

std::string inFormula(const std::string& tex) { return tex.substr(1, tex.size() - 2); }

Vector3d signsOf(const Vector3d& m_P) {
  return m_P.unaryExpr([](double x) { return x < 0 ? -1.0 : 1.0; });
}

std::string lengthOfL(double L, scene::DecimalSign sign) {
  const WrittenUnit unit = writtenUnit(scene::QuantityUnit::kAction, L);
  return fmt::format("$|\\mathbf{{L}}| = {}{}$",
                     inFormula(numberTex(fmt::format("{:.4g}", unit.written(L)), sign)),
                     inFormula(unitSuffix(unit)));
}

scene::Scene writingOf(scene::Scene scene, double L) {
  scene.show.subtitle = "Time $t$ from flip to flip, for each direction of $\\mathbf{L}$ in the body";
  scene.show.exaggerateAngles = 1;
  scene.readouts.clear();
  scene.notes.clear();
  scene.notes.push_back({});
  scene.notes.back().at = scene::Spot::kBottomLeft;
  scene.notes.back().lines = {lengthOfL(L, scene.style.decimalSign)};
  return scene;
}

draw::Stroke stroke(std::vector<glm::vec2> points_px, double width_px, const draw::Color& color,
                    bool closed = false) {
  draw::Stroke made;
  made.points_px = std::move(points_px);
  made.width_px = static_cast<float>(width_px);
  made.color = color;
  made.closed = closed;
  return made;
}

/// Returns a round spot. The spot is a stroke with round joins, because areas would lie under the lines.
draw::Stroke spot(glm::vec2 centre_px, double radius_px, const draw::Color& color) {
  constexpr int kCorners = 32;
  std::vector<glm::vec2> circle;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    circle.push_back(centre_px + glm::vec2(0.5 * radius_px * glm::dvec2(std::cos(angle), std::sin(angle))));
  }
  return stroke(std::move(circle), 1.02 * radius_px, color, true);
}

void addRectangle(draw::Picture& picture, const PixelBox& box, const draw::Color& color) {
  draw::Area area;
  area.points_px = {glm::vec2(box.left, box.top), glm::vec2(box.right, box.top), glm::vec2(box.right, box.bottom),
                    glm::vec2(box.left, box.bottom)};
  area.color = color;
  picture.areas.push_back(std::move(area));
}

void addName(draw::Picture& picture, const std::string& tex, glm::dvec2 centre_px, double em_px,
             const draw::Color& color, const draw::Color& halo) {
  if (tex.empty()) return;
  draw::Text text;
  text.tex = tex;
  text.size_px = static_cast<float>(em_px);
  text.baseline_px = glm::vec2(centre_px + glm::dvec2(-0.5 * widthOf(tex, em_px), 0.5 * kMapDigit * em_px));
  text.color = color;
  text.halo = halo;
  text.halo_px = static_cast<float>(0.14 * em_px);
  picture.texts.push_back(std::move(text));
}

}  // namespace

struct StabilityMap::Pen {
  double em_px, axisName_px, nameOfL_px, line_px;
};

struct StabilityMap::Layout {
  glm::dvec2 centre_px;
  double radius_px;
  PixelBox bar;
};

StabilityMap::StabilityMap(const scene::Scene& scene)
    : colors_(palette(scene.style)),
      m_P_(startingL_P(scene)),
      sceneDirection_P_(m_P_.normalized()),
      signs_(signsOf(m_P_)),
      scale_(scene.body.axes.moments(), m_P_.norm()),
      unit_(writtenUnit(scene::QuantityUnit::kSecond, scale_.most_s())) {
  scene_ = writingOf(scene, m_P_.norm());
}

draw::Picture StabilityMap::compose(const Moment& moment, glm::ivec2 size_px, const Sizing& sizing) const {
  expectPicture(moment, size_px);
  draw::Picture picture;
  picture.size_px = size_px;
  picture.background = colors_.paper;
  const PictureWriting writing = pictureWriting(scene_, {}, size_px, sizing, colors_);
  const Sizing type = typeScaled(sizing, scene_.style.textSize);
  const double em_px = smallSize_px(kMapType, type);
  const bool isFixed = type.fixed_px > 0;
  const Pen pen{em_px, (isFixed ? 1 : kMapNames) * em_px, (isFixed ? kFixedArrowName : kMapNames) * em_px,
                sizing.line_px * scene_.style.lineWidth};
  // Notes at the bottom corners lie beside the sphere, so they do not reduce the room for the sphere.
  const double edge_px = kMapEdge * noteEdge_px(type);
  const Layout layout =
      layoutIn({edge_px, std::max(edge_px, writing.reach.top), size_px.x - edge_px, size_px.y - edge_px}, pen);
  const auto& axes = scale_.separatrix();
  Vector3d eye;
  eye[axes.smallest] = std::cos(kAbove_rad) * std::sin(kAside_rad);
  eye[axes.middle] = std::cos(kAbove_rad) * std::cos(kAside_rad);
  eye[axes.largest] = std::sin(kAbove_rad);
  const Globe globe(eye.cwiseProduct(signs_), signs_[axes.largest] * Vector3d::Unit(axes.largest),
                    layout.centre_px, layout.radius_px);
  addBands(picture, globe);
  addCurves(picture, globe, pen);
  addAxes(picture, globe, pen);
  addScenesL(picture, globe, pen);
  addBar(picture, layout.bar, pen);
  addBlocks(picture, writing.blocks, writing.boxes);
  return picture;
}

StabilityMap::Layout StabilityMap::layoutIn(const PixelBox& room, const Pen& pen) const {
  double labels_px = 0;
  for (const StabilityScale::Tick& tick : scale_.ticks(unit_.perSi))
    labels_px = std::max(labels_px, widthOf(numberTex(tick.digits, scene_.style.decimalSign), pen.em_px));
  const double e1_radii = kAxis * std::cos(kAside_rad), e3_radii = kAxis * std::cos(kAbove_rad);
  const double name_px = kBesideName * pen.em_px;
  const double bar_px = (kBarGap + kBarWidth + kBarTick + kBarTickGap) * pen.em_px + labels_px;
  const double radius_px = std::max(1.0, std::min((room.height() - name_px) / (e3_radii + 1),
                                                  (room.width() - name_px - bar_px) / (e1_radii + 1)));
  const double width_px = (e1_radii + 1) * radius_px + name_px + bar_px;
  const double height_px = (e3_radii + 1) * radius_px + name_px;
  const glm::dvec2 centre(room.left + 0.5 * (room.width() - width_px) + e1_radii * radius_px + name_px,
                          room.top + 0.5 * (room.height() - height_px) + e3_radii * radius_px + name_px);
  const double left = centre.x + radius_px + kBarGap * pen.em_px, half = 0.5 * kBarHeight * radius_px;
  return {centre, radius_px, {left, centre.y - half, left + kBarWidth * pen.em_px, centre.y + half}};
}

// Draws each band over the wider bands, so that no paper shows between two bands.
void StabilityMap::addBands(draw::Picture& picture, const Globe& globe) const {
  picture.areas.push_back({globe.rim(), StabilityScale::color(1), 1});
  for (int band = kBands; band > 0; --band)
    for (const TimeCap& cap : scale_.caps(scale_.timeAt(static_cast<double>(band) / kBands)))
      if (auto part = globe.visiblePart(cap.outline_P, cap.contains); part.size() > 2)
        picture.areas.push_back({std::move(part), StabilityScale::color((band - 0.5) / kBands), 1});
}

void StabilityMap::addCurves(draw::Picture& picture, const Globe& globe, const Pen& pen) const {
  const auto add = [&](const Globe::Directions& curve, double lines, const draw::Color& color, float opacity) {
    for (auto& line : globe.visibleParts(curve, 0.5 * lines * pen.line_px)) {
      picture.strokes.push_back(stroke(std::move(line), lines * pen.line_px, color));
      picture.strokes.back().opacity = opacity;
    }
  };
  for (const StabilityScale::Tick& tick : scale_.ticks(unit_.perSi)) {
    const draw::Color line(scale_.share(tick.time_s) < kDarkShare ? 1 : 0);
    for (const TimeCap& cap : scale_.caps(tick.time_s)) add(cap.outline_P, kThin, line, kQuiet);
  }
  for (const bool mirrored : {false, true})
    add(scale_.separatrix().momentumCircle(1, kSeparatrixPoints, mirrored), kSeparatrix, colors_.separatrix, 1);
  picture.strokes.push_back(
      stroke(globe.rim(), std::max(kRim * pen.line_px, kLeastRim_px), colors_.quietInk, true));
}

void StabilityMap::addAxes(draw::Picture& picture, const Globe& globe, const Pen& pen) const {
  constexpr std::array kKeys{scene::LabelName::kE1, scene::LabelName::kE2, scene::LabelName::kE3};
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d direction = signs_[axis] * Vector3d::Unit(axis);
    const glm::vec2 foot = globe.at_px(direction), tip = globe.at_px(direction, kAxis);
    const glm::dvec2 along = glm::dvec2(tip - foot) / std::max(1e-9, static_cast<double>(glm::length(tip - foot)));
    const glm::dvec2 across(-along.y, along.x), neck = glm::dvec2(tip) - kHead * pen.em_px * along;
    const std::vector<glm::vec2> head{glm::vec2(neck + kHeadWidth * pen.em_px * across), tip,
                                      glm::vec2(neck - kHeadWidth * pen.em_px * across)};
    const auto add = [&](double rim, const draw::Color& color) {
      picture.strokes.push_back(stroke({foot, tip}, (kMapAxisLine + rim) * pen.line_px, color));
      picture.strokes.push_back(stroke(head, (kMapAxisLine + rim) * pen.line_px, color));
      picture.strokes.push_back(spot(foot, (kAxisFoot + 0.5 * rim) * pen.line_px, color));
    };
    add(kRing, colors_.paper);
    add(0, colors_.axis);
    std::string name = scene_.labels[kKeys[static_cast<std::size_t>(axis)]];
    if (signs_[axis] < 0 && !name.empty()) name.insert(0, "$-$");
    addName(picture, name, glm::dvec2(tip) + kBesideAxis * pen.em_px * along, pen.axisName_px, colors_.axis,
            colors_.paper);
  }
}

void StabilityMap::addScenesL(draw::Picture& picture, const Globe& globe, const Pen& pen) const {
  const glm::vec2 at = globe.at_px(sceneDirection_P_);
  picture.strokes.push_back(spot(at, (kStartDot + kRing) * pen.line_px, colors_.paper));
  picture.strokes.push_back(spot(at, kStartDot * pen.line_px, colors_.L));
  addName(picture, scene_.labels[scene::LabelName::kL], glm::dvec2(at) + glm::dvec2(1.1, -0.8) * pen.em_px,
          pen.nameOfL_px, colors_.L, colors_.paper);
}

// Draws the colour bar, whose pointed end stands for all longer times up to infinity.
void StabilityMap::addBar(draw::Picture& picture, const PixelBox& bar, const Pen& pen) const {
  const double top = bar.top + kBarTip * pen.em_px;  // upper end of the part with distinct colours
  const auto at = [&](double share) { return bar.bottom + share * (top - bar.bottom); };
  const glm::vec2 tip(0.5 * (bar.left + bar.right), bar.top);
  const std::vector<glm::vec2> outline{
      {bar.left, top}, tip, {bar.right, top}, {bar.right, bar.bottom}, {bar.left, bar.bottom}};
  picture.areas.push_back({outline, StabilityScale::color(1), 1});
  for (int band = kBands; band > 0; --band)
    addRectangle(picture, {bar.left, at(static_cast<double>(band) / kBands), bar.right, bar.bottom},
                 StabilityScale::color((band - 0.5) / kBands));
  picture.strokes.push_back(stroke(outline, std::max(kOutline * pen.line_px, 1.0), colors_.quietInk, true));
  addTimes(picture, bar, at, pen);
  const double share = scale_.share(sceneTime_s());
  const double y = share < 1 ? at(share) : std::isfinite(share) ? 0.5 * (top + bar.top) : bar.top;
  const double left = bar.left - kMark * pen.em_px;
  picture.strokes.push_back(stroke({{left, y}, {bar.left, y}}, kMapAxisLine * pen.line_px, colors_.L));
  addName(picture, scene_.labels[scene::LabelName::kL], {left - kBesideMark * pen.em_px, y}, pen.nameOfL_px,
          colors_.L, colors_.paper);
}

void StabilityMap::addTimes(draw::Picture& picture, const PixelBox& bar, const std::function<double(double)>& at,
                            const Pen& pen) const {
  const double em = pen.em_px, right = bar.right + kBarTick * em;
  const auto label = [&](const std::string& tex, double y, const draw::Color& color) {
    addLine(picture, tex, right + kBarTickGap * em, y + 0.5 * kMapDigit * em, Align::kLeft, em, color);
  };
  for (const StabilityScale::Tick& tick : scale_.ticks(unit_.perSi)) {
    const double y = at(scale_.share(tick.time_s));
    picture.strokes.push_back(stroke({{bar.right, y}, {right, y}}, kThin * pen.line_px, colors_.quietInk));
    label(numberTex(tick.digits, scene_.style.decimalSign), y, colors_.ink);
  }
  picture.strokes.push_back(stroke({{0.5 * (bar.left + bar.right), bar.top}, {right, bar.top}},
                                   kSeparatrix * pen.line_px, colors_.separatrix));
  label("$\\infty$", bar.top, colors_.separatrix);
  addLine(picture, axisLabel("t", unit_), bar.left, bar.top - kOverBar * em, Align::kLeft, em, colors_.ink);
}

}  // namespace poinsot::stage
