// SPDX-License-Identifier: Apache-2.0
#include "stage/stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "core/error.h"
#include "stage/arrow.h"
#include "stage/body_figure.h"
#include "stage/construction_figure.h"
#include "stage/framing.h"
#include "stage/label_layout.h"
#include "stage/palette.h"
#include "stage/picture_motion.h"
#include "stage/scales.h"
#include "stage/to_picture.h"
#include "text/math_setter.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

// In picture lengths.
constexpr double kVectorRadius = 0.019, kAxisRadius = 0.0125;
constexpr double kAxisInEllipsoid = 0.88, kAxisBeyondBody = 1.3;
constexpr double kMostAxes =
    0.8;  // of an axis is framed: labels keep themselves inside, and few axes point outwards
constexpr double kLine = 2.0 / 1080, kLabel = 0.044, kTitle = 0.042, kSubtitle = 0.03, kNote = 0.025,
                 kEdge = 0.055;
// In em.
constexpr double kCapHeight = 0.7, kDescent = 0.2, kLeading = 0.3;

bool showsConstruction(const scene::Scene& scene) {
  const auto& show = scene.show;
  return scene.motion.omega_B.norm() > 0 &&
         (show.ellipsoid.visible || show.plane.visible || show.polhode.visible || show.herpolhode.visible ||
          show.contact.visible);
}

// What type and lines are sized by: the height of the largest 16:9 picture inside this one.
double referenceHeight(glm::vec2 size_px) {
  return std::min(static_cast<double>(size_px.y), static_cast<double>(size_px.x) * 9 / 16);
}

// 200000 as "200 000"; a number with decimals stays as it is.
std::string grouped(double x) {
  std::string digits = fmt::format("{:.15g}", x);
  if (digits.find_first_not_of("0123456789") != std::string::npos) return digits;
  for (auto i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3)
    digits.insert(static_cast<std::size_t>(i), "\u2009");
  return digits;
}

// How much of a point is seen past the body: 0 behind it or inside, 1 clear of it, smooth between. The sight line
// is followed from the point towards the eye.
float seenPast(const BodyFigure& body, double scale, const Eigen::Matrix3d& R_VB, const Vector3d& point_V,
               const Vector3d& eye_V) {
  constexpr int kSteps = 32;
  const Vector3d towardEye = (eye_V - point_V).normalized() * 2 * scale * body.radius();
  double nearest = 2;
  for (int i = 0; i <= kSteps; ++i)
    nearest = std::min(nearest, body.gauge(R_VB.transpose() * (point_V + towardEye * i / kSteps) / scale));
  return static_cast<float>(glm::smoothstep(0.95, 1.25, nearest));
}

// Bad TeX is found before the first frame, and named by its key and place.
void checkTex(const std::string& key, const std::string& tex, const core::SourceLocation& place) {
  try {
    text::setTex(tex);
  } catch (const core::Error& error) {
    throw core::Error(core::ErrorKind::kScene, key + ": " + error.message(),
                      place.file.empty() ? std::nullopt : std::optional(place));
  }
}

}  // namespace

struct Stage::Plan {
  scene::Scene scene;
  Palette colors;
  PictureMotion motion;
  BodyFigure body;
  Scales scales;
  std::optional<ConstructionFigure> construction;
  Extent extent;  // of the whole motion

  explicit Plan(scene::Scene s)
      : scene(std::move(s)),
        colors(palette(scene.style.theme)),
        motion(scene),
        body(scene),
        scales(makeScales(scene, motion, body)) {
    checkTex("show.title", scene.show.title, scene.show.titlePlace);
    checkTex("show.subtitle", scene.show.subtitle, scene.show.subtitlePlace);
    if (showsConstruction(scene)) construction.emplace(scene, motion, scales);
    extent = wholeExtent();
  }

  // One principal axis, from the centre to inside the ellipsoid or beyond the body.
  double axisLength(int axis) const {
    const double body_length = kAxisBeyondBody * scales.body * body.halfExtents()[axis] + 0.12;
    if (!construction || !scene.show.ellipsoid.visible) return scene.show.principalAxes.scale * body_length;
    return scene.show.principalAxes.scale * kAxisInEllipsoid * construction->semiAxes()[axis];
  }

  Extent wholeExtent() const;
  draw::Camera camera(glm::vec2 size_px) const;
  void addVectors(draw::DrawList& list, const PictureState& state) const;
  void addAxes(draw::DrawList& list, const PictureState& state) const;
  void addHeight(draw::DrawList& list, const PictureState& state, std::vector<Label>& labels) const;
  std::vector<Label> labels(const draw::DrawList& list, const PictureState& state) const;
  void addPlaneName(draw::DrawList& list, const PictureState& state) const;
  void addTitle(draw::DrawList& list) const;
};

Extent Stage::Plan::wholeExtent() const {
  Extent whole;
  if (construction) whole.points_V = construction->outermostPoints();
  const PictureState start = motion.at(0);
  if (scene.show.L.visible && start.L_V.norm() > 0)
    whole.points_V.push_back(scales.lengthOfL * start.L_V.normalized());
  if (scene.show.body.visible) whole.ballRadius = scales.body * body.radius();
  const bool inside = construction && scene.show.ellipsoid.visible && scene.show.principalAxes.scale <= 1;
  for (int axis = 0; axis < 3 && scene.show.principalAxes.visible && !inside; ++axis)
    whole.ballRadius = std::max(whole.ballRadius, kMostAxes * axisLength(axis));
  if (scene.show.omega.visible)
    for (const PathPoint& p : motion.outline())
      whole.points_V.push_back(scales.omega * (motion.R_VW(p.filmTime_s) * p.omega_W));
  if (whole.points_V.empty() && whole.ballRadius == 0) whole.ballRadius = scales.reach;
  return whole;
}

draw::Camera Stage::Plan::camera(glm::vec2 size_px) const {
  Margins margins;
  // The title's lines stand over the picture, not in it.
  if (!scene.show.title.empty()) margins.top = 0.1;
  return frameAll(scene.camera, extent, margins, size_px);
}

void Stage::Plan::addVectors(draw::DrawList& list, const PictureState& state) const {
  const double width = kVectorRadius * scene.style.lineWidth;
  if (scene.show.L.visible && state.L_V.norm() > 0)
    addArrow(list, Vector3d::Zero(), scales.lengthOfL * state.L_V.normalized(), width, colors.L);
  if (scene.show.omega.visible)
    addArrow(list, Vector3d::Zero(), scales.omega * state.omega_V, width, colors.omega);
}

void Stage::Plan::addAxes(draw::DrawList& list, const PictureState& state) const {
  if (!scene.show.principalAxes.visible) return;
  for (int axis = 0; axis < 3; ++axis)
    addArrow(list, Vector3d::Zero(), axisLength(axis) * state.R_VB.col(axis), kAxisRadius * scene.style.lineWidth,
             colors.axis);
}

std::vector<Label> Stage::Plan::labels(const draw::DrawList& list, const PictureState& state) const {
  std::vector<Label> labels;
  const double H = referenceHeight(list.camera.size_px);
  const auto size_px = static_cast<float>(kLabel * scene.style.textSize * H);
  const glm::vec2 centre_px = project(list.camera, glm::vec3(0));
  const auto add = [&](const std::string& tex, const Vector3d& tip_V, glm::vec2 direction,
                       const draw::Color& color, float size) {
    const glm::vec2 anchor = project(list.camera, toPicture(tip_V));
    labels.push_back({tex, anchor, direction, 0.35f * size, size, color});
  };
  if (scene.show.L.visible && state.L_V.norm() > 0) {
    const Vector3d tip = scales.lengthOfL * state.L_V.normalized();
    add("$\\mathbf{L}$", tip, {1, 0}, colors.L, 1.15f * size_px);
  }
  if (scene.show.omega.visible && state.omega_V.norm() > 0) {
    const auto at = [&](double share) { return Vector3d(share * scales.omega * state.omega_V); };
    const float outwards = project(list.camera, toPicture(at(1))).x - centre_px.x;
    if (scene.show.plane.visible || scene.show.ellipsoid.visible) {
      // Always on the left, of the shaft or of L where that is farther left: it never changes sides.
      add("$\\boldsymbol{\\omega}$", at(0.62), {-1, 0}, colors.omega, 1.15f * size_px);
      labels.back().anchor_px.x = std::min(labels.back().anchor_px.x, centre_px.x);
    } else {
      // Over the tip, leaning outwards: it glides from side to side as the tip goes round.
      add("$\\boldsymbol{\\omega}$", at(1), {std::clamp(outwards / (2 * size_px), -1.0f, 1.0f), -1.1f},
          colors.omega, 1.15f * size_px);
    }
  }
  if (scene.show.principalAxes.visible) {
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d tip = axisLength(axis) * state.R_VB.col(axis);
      const glm::vec2 out = project(list.camera, toPicture(tip)) - centre_px;
      // An axis that points at the eye has no direction in the picture: its label leans upwards.
      add(fmt::format("$\\hat{{\\mathbf{{e}}}}_{}$", axis + 1), tip, out + glm::vec2(0, -1.2f * size_px),
          colors.axis, 0.85f * size_px);
      if (scene.show.body.visible)
        labels.back().opacity = seenPast(body, scales.body, state.R_VB, tip, fromPicture(list.camera.eye_W));
    }
  }
  return labels;
}

// The height of the centre above the plane, 2T/L (eq 40), as a dimension line beside the ellipsoid.
void Stage::Plan::addHeight(draw::DrawList& list, const PictureState& state, std::vector<Label>& labels) const {
  if (!construction || !scene.show.plane.visible || !scene.show.height.visible) return;
  const Vector3d down = state.L_V.normalized();
  const Vector3d across = down.cross(fromPicture(list.camera.R_WC[2]));
  if (across.norm() < 0.05) return;  // seen from straight above: the height is not to be seen
  const Vector3d left = across.normalized();
  const double away = 1.08 * construction->semiAxes().maxCoeff();
  const Vector3d foot = construction->planeHeight() * down + away * left, head = away * left;
  const double H = referenceHeight(list.camera.size_px);
  const auto line = [&](const Vector3d& a, const Vector3d& b) {
    draw::Curve curve;
    curve.points_W = {toPicture(a), toPicture(b)};
    curve.width_px = static_cast<float>(0.9 * kLine * H * scene.style.lineWidth);
    curve.lift_W = 0.004f;
    curve.material.color = colors.L;
    list.curves.push_back(std::move(curve));
  };
  line(foot, head);
  line(foot - 0.035 * left, foot + 0.035 * left);
  line(head - 0.035 * left, head + 0.035 * left);
  if (!scene.show.labels) return;
  const auto size_px = static_cast<float>(0.72 * kLabel * scene.style.textSize * H);
  const glm::vec2 a = project(list.camera, toPicture(foot)), b = project(list.camera, toPicture(head));
  const glm::vec2 middle = 0.5f * (a + b), centre_px = project(list.camera, glm::vec3(0));
  glm::vec2 aside(a.y - b.y, b.x - a.x);
  if (glm::dot(aside, middle - centre_px) < 0) aside = -aside;
  labels.push_back({"$2T/L$", middle, aside, 0.4f * size_px, size_px, colors.L});
}

// The plane's name: under the edge that runs to its lowest corner from the left, or over the one that runs to its
// highest where the plane is above the body.
void Stage::Plan::addPlaneName(draw::DrawList& list, const PictureState& state) const {
  if (!construction || !scene.show.plane.visible || !scene.show.labels) return;
  const auto corners_V = construction->planeCorners(state.R_VW);
  std::array<glm::vec2, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = project(list.camera, toPicture(corners_V[i]));
  const bool above =
      project(list.camera, toPicture(Vector3d(construction->planeHeight() * state.L_V.normalized()))).y <
      project(list.camera, glm::vec3(0)).y;
  const auto outer = [above](glm::vec2 a, glm::vec2 b) { return above ? a.y > b.y : a.y < b.y; };
  const auto tip =
      static_cast<std::size_t>(std::max_element(corners.begin(), corners.end(), outer) - corners.begin());
  const glm::vec2 before = corners[(tip + 3) % 4], after = corners[(tip + 1) % 4];
  const auto size_px = static_cast<float>(kNote * referenceHeight(list.camera.size_px) * scene.style.textSize);
  const glm::vec2 middle = 0.5f * ((before.x < after.x ? before : after) + corners[tip]);
  const std::string tex = "invariable plane";
  const auto width = static_cast<float>(text::setTex(tex).width_em) * size_px;
  const glm::vec2 place(std::max(middle.x - 0.8f * width, size_px), middle.y + (above ? -1.2f : 2.0f) * size_px);
  list.texts.push_back({tex, place, size_px, colors.L, 1, colors.paper, 0.1f * size_px});
}

void Stage::Plan::addTitle(draw::DrawList& list) const {
  const double H = referenceHeight(list.camera.size_px) * scene.style.textSize;
  const double left = kEdge * H, room = static_cast<double>(list.camera.size_px.x) - 2 * left;
  double y = kEdge * H;
  const auto addLine = [&](const std::string& tex, double size, const draw::Color& color) {
    const text::GlyphRun run = text::setTex(tex);
    // A line too long for the picture is set smaller.
    const double size_px = std::min(size * H, room / std::max(run.width_em, 1e-9));
    y += size_px * std::max(run.inkTop_em, kCapHeight);
    list.texts.push_back({tex, glm::vec2(left, y), static_cast<float>(size_px), color, 1, std::nullopt, 0});
    y += size_px * (std::max(-run.inkBottom_em, kDescent) + kLeading);
  };
  if (!scene.show.title.empty()) addLine("\\textbf{" + scene.show.title + "}", kTitle, colors.ink);
  if (!scene.show.subtitle.empty()) addLine(scene.show.subtitle, kSubtitle, colors.quietInk);
  // What is not to scale is said in the picture.
  y = static_cast<double>(list.camera.size_px.y) - (kEdge + kNote) * H;
  if (scene.show.exaggerateAngles > 1)
    addLine("angles drawn " + grouped(scene.show.exaggerateAngles) + " times larger", kNote, colors.quietInk);
}

Stage::Stage(scene::Scene scene) : plan_(std::make_unique<Plan>(std::move(scene))) {}
Stage::~Stage() = default;
Stage::Stage(Stage&&) noexcept = default;

draw::DrawList Stage::compose(double filmTime_s, glm::ivec2 size_px) const {
  const Plan& plan = *plan_;
  draw::DrawList list;
  list.camera = plan.camera(size_px);
  list.background = plan.colors.paper;
  const PictureState state = plan.motion.at(filmTime_s);
  const double line_px = kLine * referenceHeight(size_px) * plan.scene.style.lineWidth;
  if (plan.scene.show.body.visible) plan.body.add(list, state.R_VB, plan.scales.body, plan.colors, line_px);
  plan.addAxes(list, state);
  plan.addVectors(list, state);
  if (plan.construction) plan.construction->add(list, filmTime_s, state, plan.colors, line_px);
  std::vector<Label> labels;
  if (plan.scene.show.labels) labels = plan.labels(list, state);
  plan.addHeight(list, state, labels);
  addLabels(list, labels, plan.colors.paper);
  plan.addPlaneName(list, state);
  plan.addTitle(list);
  return list;
}

const scene::Scene& Stage::scene() const { return plan_->scene; }
double Stage::speed() const { return plan_->motion.speed(); }

}  // namespace poinsot::stage
