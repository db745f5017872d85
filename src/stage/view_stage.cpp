// SPDX-License-Identifier: Apache-2.0
#include "stage/view_stage.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "core/error.h"
#include "stage/body/body_figure.h"
#include "stage/camera_path.h"
#include "stage/figures/actors.h"
#include "stage/figures/construction.h"
#include "stage/figures/presence.h"
#include "stage/figures/principal_axes_figure.h"
#include "stage/figures/stand_figure.h"
#include "stage/framing.h"
#include "stage/palette.h"
#include "stage/picture_motion.h"
#include "stage/scales.h"
#include "stage/to_picture.h"
#include "stage/type/label_layout.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

// Returns positions that the origin of space and points of the flight's path take relative to the moving body,
// which the camera follows. These positions may lie outside the picture.
std::vector<Vector3d> passing_V(const PictureMotion& motion, double flightScale) {
  constexpr std::size_t kStride = 50;
  std::vector<Vector3d> ends{Vector3d::Zero()}, points;
  for (std::size_t i = 0; i < motion.outline().size(); i += kStride)
    ends.push_back(flightScale * motion.atPlayed(motion.outline()[i].played_s).centre_V);
  for (const Vector3d& end : ends)
    for (const Vector3d& body : ends) points.emplace_back(end - body);
  return points;
}

// Returns the extent of everything that is drawn during the film, so that the scale does not change with time. If
// the body passes by, points are relative to the origin of space.
Extent wholeExtent(const std::vector<ShownActor>& actors, const PictureMotion& motion, const Scales& scales,
                   double heldFlight) {
  Extent whole;
  for (const ShownActor& shown : actors) whole.ballRadius = std::max(whole.ballRadius, shown.actor->ballRadius());
  for (const PathPoint& p : motion.outline()) {
    const PictureState state = motion.atPlayed(p.played_s);
    const Vector3d centre_V = heldFlight * state.centre_V;
    for (const ShownActor& shown : actors)
      for (const Vector3d& point_V : shown.actor->outermostPoints(state))
        whole.points_V.push_back(centre_V + point_V);
  }
  if (whole.points_V.empty() && whole.ballRadius == 0) whole.ballRadius = scales.reach;
  if (!motion.flight()) whole.points_V.push_back(Vector3d::Zero());  // all arrows start at the origin
  return whole;
}

// Throws if the flight is too long for a picture: the squares of the camera's coordinates would overflow a float.
void refuseTooFar(const Extent& extent) {
  constexpr double kFarthest = 1e18;
  double farthest = 0;
  for (const auto* points : {&extent.points_V, &extent.passing_V})
    for (const Vector3d& point_V : *points) farthest = std::max(farthest, point_V.cwiseAbs().maxCoeff());
  if (farthest <= kFarthest) return;
  throw core::limitError(
      fmt::format("the flight is too long for a picture: it reaches {:.3g} times the size of the body; "
                  "choose motion times nearer to 0 by time.start, time.speed or time.duration",
                  farthest));
}

// Moves the middle of the extent to the origin. Returns the former middle.
Vector3d centre(Extent& extent) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& point_V : extent.points_V) box.extend(point_V);
  for (Vector3d& point_V : extent.points_V) point_V -= box.center();
  return box.center();
}

}  // namespace

struct ViewStage::Plan {
  scene::Scene scene;
  Palette colors;
  PictureMotion motion;
  BodyFigure body;
  Scales scales;
  double heldFlight = 0;  // scale of the flight's path; 0 if the camera follows the body
  std::optional<Construction> construction;
  std::vector<ShownActor> actors;
  Extent extent;
  Vector3d middle_V = Vector3d::Zero();  // middle of the extent in space; zero unless the body flies in the view
  CameraPath path;
  PathFraming framing;
  PresencePlan presence;

  Plan(scene::Scene s, std::shared_ptr<const physics::Motion> shared)
      : scene(std::move(s)),
        colors(palette(scene.style)),
        motion(scene, std::move(shared)),
        body(scene),
        scales(makeScales(scene, motion, body)),
        path(scene.camera, scene.timeline, scene.time.duration_s),
        framing(path),
        presence(scene.timeline) {
    if (showsConstruction(scene.show, motion)) construction.emplace(motion, scales);
    const Construction* made = construction ? &*construction : nullptr;
    const Eigen::Vector3d axisLengths = principalAxisLengths(scene, body, scales, made);
    actors = makeActors({scene, motion, body, scales, made, axisLengths});
    if (!scene.camera.follow) heldFlight = scales.flight;
    extent = wholeExtent(actors, motion, scales, heldFlight);
    if (motion.flight()) middle_V = centre(extent);
    if (motion.flight() && scene.camera.follow) extent.passing_V = passing_V(motion, scales.flight);
    refuseTooFar(extent);
  }

  /// Returns a camera that frames the whole extent, whose middle is at the origin.
  draw::Camera framedCamera(double filmTime_s, const PanelFrame& frame) const {
    return framing.camera(path.at(filmTime_s), extent, frame.margins, frame.size_px, frame.mostUnit_px);
  }
  draw::Camera cameraAt(double filmTime_s, const PanelFrame& frame, const PictureState& state) const;
  void nameCentre(const Canvas& canvas, const PictureState& state) const;
  void addActors(const Canvas& canvas, double filmTime_s, const PictureState& state) const;
  double presenceOf(std::string_view thing, double filmTime_s) const;
  /// Returns whether the user enlarges or shifts the picture, which otherwise contains the whole motion.
  bool isAimed(double filmTime_s) const {
    const scene::Camera camera = path.at(filmTime_s);
    return camera.zoom > 1 || !camera.shift.isZero(0);
  }
};

// Returns the presence of an object, from 0 (absent) to 1 (fully shown). The height line fades with the plane.
double ViewStage::Plan::presenceOf(std::string_view thing, double filmTime_s) const {
  const double there = presence.at(thing, filmTime_s);
  return thing == "height" ? std::min(there, presence.at("plane", filmTime_s)) : there;
}

draw::Camera ViewStage::Plan::cameraAt(double filmTime_s, const PanelFrame& frame,
                                       const PictureState& state) const {
  return draw::moved(framedCamera(filmTime_s, frame), toPicture(Vector3d(middle_V - heldFlight * state.centre_V)));
}

/// Names the centre of mass and the point about which a top rotates. The centre of a top is unknown if only its
/// moments are given.
void ViewStage::Plan::nameCentre(const Canvas& canvas, const PictureState& state) const {
  const Vector3d fixed_V = Vector3d::Zero();  // the point about which the body rotates
  if (!standsOnPivot(scene)) return canvas.point("centre", fixed_V);
  canvas.point("pivot", fixed_V);
  if (scene.body.mass)
    canvas.point("centre", scales.body * state.R_VB * (scene.body.mass->centre_B() - scene.body.fixedPoint_B()));
}

void ViewStage::Plan::addActors(const Canvas& canvas, double filmTime_s, const PictureState& state) const {
  for (const ShownActor& shown : actors) {
    const double there = presenceOf(shown.name, filmTime_s);
    if (there == 0) continue;
    const DrawMark mark(canvas.list, canvas.labels);
    shown.actor->add(canvas, filmTime_s, state);
    if (there < 1) mark.fade(canvas.list, canvas.labels, shown.actor->growsFrom(state), there);
  }
  const auto names = static_cast<float>(presence.at("labels", filmTime_s));
  for (Label& label : canvas.labels) label.opacity *= names;
  if (names == 0) canvas.labels.clear();
}

ViewStage::ViewStage(scene::Scene scene, std::shared_ptr<const physics::Motion> motion)
    : plan_(std::make_unique<Plan>(std::move(scene), std::move(motion))) {}
ViewStage::~ViewStage() = default;
ViewStage::ViewStage(ViewStage&&) noexcept = default;

draw::DrawList ViewStage::compose(const Moment& moment, const PanelFrame& frame) const {
  const Plan& plan = *plan_;
  const scene::Style& style = plan.scene.style;
  draw::DrawList list;
  const PictureState state = plan.motion.at(moment.filmTime_s);
  list.camera = plan.cameraAt(moment.filmTime_s, frame, state);
  list.isCutOff =
      plan.isAimed(moment.filmTime_s) && cutsOff(plan.framedCamera(moment.filmTime_s, frame), plan.extent);
  list.background = plan.colors.paper;
  const double line_px = frame.line_px * style.lineWidth;
  const double label_px = plan.scene.show.labels ? kLabelSize * frame.type_px * style.textSize : 0;
  std::vector<Label> labels;
  const Canvas canvas{list,
                      labels,
                      plan.colors,
                      plan.scene.labels,
                      line_px,
                      style.lineWidth,
                      label_px,
                      frame.least_px * style.textSize,
                      frame.arrowName,
                      moment.still};
  plan.nameCentre(canvas, state);
  plan.addActors(canvas, moment.filmTime_s, state);
  addLabels(list, labels, plan.colors.paper, static_cast<float>(frame.heading_px), frame.taken);
  return list;
}

double ViewStage::metre_px(const PanelFrame& frame) const {
  return plan_->scales.body * plan_->framing.unit_px(plan_->extent, frame.margins, frame.size_px);
}

double ViewStage::bodyScale() const { return plan_->scales.body; }
double ViewStage::flightScale() const { return plan_->scales.flight / plan_->scales.body; }
double ViewStage::speed() const { return plan_->motion.speed(); }

}  // namespace poinsot::stage
