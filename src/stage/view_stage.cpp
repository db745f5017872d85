// SPDX-License-Identifier: Apache-2.0
#include "stage/view_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "stage/actors.h"
#include "stage/arrow.h"
#include "stage/body_figure.h"
#include "stage/construction_figure.h"
#include "stage/framing.h"
#include "stage/label_layout.h"
#include "stage/lettering.h"
#include "stage/palette.h"
#include "stage/picture_motion.h"
#include "stage/scales.h"
#include "stage/stand_figure.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

// In picture lengths.
constexpr double kVectorRadius = 0.019, kAxisRadius = 0.0125;
constexpr double kAxisInEllipsoid = 0.88, kAxisBeyondBody = 1.3;
constexpr double kLeastAxis = 0.3;  // of half the body's longest extent: for an axis that leads away from it
constexpr double kMostAxes =
    0.8;  // of an axis is framed: labels keep themselves inside, and few axes point outwards
// In shares of the reference height.
constexpr double kLine = 2.0 / 1080, kLabel = 0.044;

bool showsConstruction(const scene::Scene& scene, const PictureMotion& motion) {
  const auto& show = scene.show;
  return !motion.liveliest().omega_P.isZero(0) &&
         (show.ellipsoid.visible || show.plane.visible || show.polhode.visible || show.herpolhode.visible ||
          show.contact.visible);
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

}  // namespace

struct ViewStage::Plan {
  scene::Scene scene;
  Palette colors;
  PictureMotion motion;
  BodyFigure body;
  Scales scales;
  std::optional<ConstructionFigure> construction;
  std::optional<StandFigure> stand;
  std::vector<std::unique_ptr<const Actor>> actors;
  Extent extent;  // of the whole motion

  Plan(scene::Scene s, std::shared_ptr<const physics::Motion> shared)
      : scene(std::move(s)),
        colors(palette(scene.style.theme)),
        motion(scene, std::move(shared)),
        body(scene),
        scales(makeScales(scene, motion, body)) {
    if (showsConstruction(scene, motion)) construction.emplace(scene, motion, scales);
    if (standsOnPivot(scene)) stand.emplace(scene, motion, body, scales.body);
    actors = makeActors({scene, motion, scales, {axisLength(0), axisLength(1), axisLength(2)}});
    extent = wholeExtent();
  }

  // One principal axis, from the fixed point to inside the ellipsoid or beyond the body.
  double axisLength(int axis) const {
    if (construction && scene.show.ellipsoid.visible)
      return scene.show.principalAxes.scale * kAxisInEllipsoid * construction->semiAxes()[axis];
    const double least_m = kLeastAxis * body.halfExtents().maxCoeff();
    const double reach_m = std::max(body.reachAlongAxes()[axis], least_m);
    return scene.show.principalAxes.scale * (kAxisBeyondBody * scales.body * reach_m + 0.12);
  }

  Extent wholeExtent() const;
  void addAxes(Extent& whole) const;
  void addActors(Extent& whole) const;
  void addVectors(draw::DrawList& list, const PictureState& state) const;
  void addAxes(draw::DrawList& list, const PictureState& state) const;
  void addHeight(draw::DrawList& list, double type_px, const PictureState& state,
                 std::vector<Label>& labels) const;
  std::vector<Label> labels(const draw::DrawList& list, double type_px, const PictureState& state) const;
};

// A body about its centre of mass turns in a ball; one on a pivot takes the place that it sweeps.
Extent ViewStage::Plan::wholeExtent() const {
  Extent whole;
  if (construction) whole.points_V = construction->outermostPoints();
  if (scene.show.body.visible && stand)
    whole.points_V.insert(whole.points_V.end(), stand->outermostPoints().begin(), stand->outermostPoints().end());
  else if (scene.show.body.visible)
    whole.ballRadius = scales.body * body.radius();
  const bool inside = construction && scene.show.ellipsoid.visible && scene.show.principalAxes.scale <= 1;
  if (scene.show.principalAxes.visible && !inside) addAxes(whole);
  for (const PathPoint& p : motion.outline()) {
    const Eigen::Matrix3d R_VW = motion.R_VW(p.filmTime_s);
    if (scene.show.L.visible) whole.points_V.push_back(scales.L * (R_VW * p.L_W));
    if (scene.show.omega.visible) whole.points_V.push_back(scales.omega * (R_VW * p.omega_W));
  }
  addActors(whole);
  if (whole.points_V.empty() && whole.ballRadius == 0) whole.ballRadius = scales.reach;
  return whole;
}

void ViewStage::Plan::addAxes(Extent& whole) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (!stand) whole.ballRadius = std::max(whole.ballRadius, kMostAxes * axisLength(axis));
    if (!stand) continue;
    for (const PathPoint& p : motion.outline())
      whole.points_V.push_back(axisLength(axis) * motion.at(p.filmTime_s).R_VP.col(axis));
  }
}

void ViewStage::Plan::addActors(Extent& whole) const {
  constexpr int kInstants = 64;
  for (int i = 0; i <= kInstants && !actors.empty(); ++i) {
    const PictureState state = motion.at(motion.duration_s() * i / kInstants);
    for (const auto& actor : actors)
      for (const Vector3d& p : actor->outermostPoints(state)) whole.points_V.push_back(p);
  }
}

void ViewStage::Plan::addVectors(draw::DrawList& list, const PictureState& state) const {
  const double width = kVectorRadius * scene.style.lineWidth;
  if (scene.show.L.visible && state.L_V.norm() > 0)
    addArrow(list, Vector3d::Zero(), scales.L * state.L_V, width, colors.L);
  if (scene.show.omega.visible)
    addArrow(list, Vector3d::Zero(), scales.omega * state.omega_V, width, colors.omega);
}

void ViewStage::Plan::addAxes(draw::DrawList& list, const PictureState& state) const {
  if (!scene.show.principalAxes.visible) return;
  for (int axis = 0; axis < 3; ++axis)
    addArrow(list, Vector3d::Zero(), axisLength(axis) * state.R_VP.col(axis), kAxisRadius * scene.style.lineWidth,
             colors.axis);
}

std::vector<Label> ViewStage::Plan::labels(const draw::DrawList& list, double type_px,
                                           const PictureState& state) const {
  std::vector<Label> labels;
  const auto size_px = static_cast<float>(kLabel * scene.style.textSize * type_px);
  const glm::vec2 centre_px = project(list.camera, glm::vec3(0));
  const auto add = [&](const std::string& tex, const Vector3d& tip_V, glm::vec2 direction,
                       const draw::Color& color, float size) {
    const glm::vec2 anchor = project(list.camera, toPicture(tip_V));
    labels.push_back({tex, anchor, direction, 0.35f * size, size, color});
  };
  if (scene.show.L.visible && state.L_V.norm() > 0) {
    const Vector3d tip = scales.L * state.L_V;
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
      const Vector3d tip = axisLength(axis) * state.R_VP.col(axis);
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
void ViewStage::Plan::addHeight(draw::DrawList& list, double type_px, const PictureState& state,
                                std::vector<Label>& labels) const {
  if (!construction || !scene.show.plane.visible || !scene.show.height.visible || state.atRest()) return;
  const Vector3d down = state.L_V.normalized();
  const Vector3d across = down.cross(fromPicture(list.camera.R_WC[2]));
  if (across.norm() < 0.05) return;  // seen from straight above: the height is not to be seen
  const Vector3d left = across.normalized();
  const double away = 1.08 * construction->semiAxes().maxCoeff();
  const Vector3d foot = construction->planeHeight(state) * down + away * left, head = away * left;
  const auto line = [&](const Vector3d& a, const Vector3d& b) {
    draw::Curve curve;
    curve.points_W = {toPicture(a), toPicture(b)};
    curve.width_px = static_cast<float>(0.9 * kLine * type_px * scene.style.lineWidth);
    curve.lift_W = 0.004f;
    curve.material.color = colors.L;
    list.curves.push_back(std::move(curve));
  };
  line(foot, head);
  line(foot - 0.035 * left, foot + 0.035 * left);
  line(head - 0.035 * left, head + 0.035 * left);
  if (!scene.show.labels) return;
  const auto size_px = static_cast<float>(0.72 * kLabel * scene.style.textSize * type_px);
  const glm::vec2 a = project(list.camera, toPicture(foot)), b = project(list.camera, toPicture(head));
  const glm::vec2 middle = 0.5f * (a + b), centre_px = project(list.camera, glm::vec3(0));
  glm::vec2 aside(a.y - b.y, b.x - a.x);
  if (glm::dot(aside, middle - centre_px) < 0) aside = -aside;
  labels.push_back({"$2T/L$", middle, aside, 0.4f * size_px, size_px, colors.L});
}

ViewStage::ViewStage(scene::Scene scene, std::shared_ptr<const physics::Motion> motion)
    : plan_(std::make_unique<Plan>(std::move(scene), std::move(motion))) {}
ViewStage::~ViewStage() = default;
ViewStage::ViewStage(ViewStage&&) noexcept = default;

draw::DrawList ViewStage::compose(double filmTime_s, const PanelFrame& frame) const {
  const Plan& plan = *plan_;
  draw::DrawList list;
  list.camera = frameAll(plan.scene.camera, plan.extent, frame.margins, frame.size_px, frame.mostUnit_px);
  list.background = plan.colors.paper;
  const PictureState state = plan.motion.at(filmTime_s);
  const double line_px = kLine * frame.type_px * plan.scene.style.lineWidth;
  if (plan.scene.show.body.visible) plan.body.add(list, state.R_VB, plan.scales.body, plan.colors, line_px);
  if (plan.stand && plan.scene.show.body.visible) plan.stand->add(list, state, plan.colors);
  plan.addAxes(list, state);
  plan.addVectors(list, state);
  if (plan.construction) plan.construction->add(list, filmTime_s, state, plan.colors, line_px);
  std::vector<Label> labels;
  if (plan.scene.show.labels) labels = plan.labels(list, frame.type_px, state);
  plan.addHeight(list, frame.type_px, state, labels);
  const double type_px = plan.scene.show.labels ? kLabel * plan.scene.style.textSize * frame.type_px : 0;
  const Canvas canvas{list, labels, plan.colors, line_px, plan.scene.style.lineWidth, type_px};
  for (const auto& actor : plan.actors) actor->add(canvas, filmTime_s, state);
  addLabels(list, labels, plan.colors.paper, static_cast<float>(frame.heading_px));
  if (plan.construction && plan.scene.show.plane.visible && plan.scene.show.labels && !state.atRest())
    addPlaneName(list, *plan.construction, state, frame.type_px * plan.scene.style.textSize, plan.colors);
  return list;
}

double ViewStage::metre_px(const PanelFrame& frame) const {
  return plan_->scales.body * fittingUnit_px(plan_->scene.camera, plan_->extent, frame.margins, frame.size_px);
}

double ViewStage::bodyScale() const { return plan_->scales.body; }
double ViewStage::speed() const { return plan_->motion.speed(); }

}  // namespace poinsot::stage
