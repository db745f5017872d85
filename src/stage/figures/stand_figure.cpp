// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/stand_figure.h"

#include <algorithm>
#include <cmath>

#include "stage/figures/actor.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kHeight = 0.34, kFoot = 0.18;  // height and foot radius of the pedestal, in radii of the body
constexpr double kTip = 0.022, kJoint = 0.032, kStandRod = 0.012;  // radii, in units of the picture's axes V
constexpr int kFootRimPoints = 12;
constexpr double kMayDip = 0.01;  // tolerated depth below the tip, in radii of the body; a drawn apex is inexact

/// Returns the lowest inertial height that the body reaches in the film, relative to the pivot.
double lowestPoint_W(const PictureMotion& motion, const BodyFigure& body, double scale) {
  double lowest = 0;
  for (const PathPoint& p : motion.outline()) {
    const PictureState state = motion.atPlayed(p.played_s);
    const Vector3d down_B = -state.R_VB.transpose() * state.R_VW.col(2);
    lowest = std::min(lowest, -scale * down_B.dot(body.supportPoint(down_B)));
  }
  return lowest;
}

// Returns true if the body never touches the pedestal, a cone below the pivot. The body must lie above the plane
// through the pivot that is perpendicular to the line from the pivot to the centre of mass. The pedestal lies
// below this plane unless the line is tilted too far.
bool leavesRoomBelow(const PictureMotion& motion, const BodyFigure& body, const Vector3d& toCentre_B) {
  const Vector3d away_B = toCentre_B.normalized();
  if (-away_B.dot(body.supportPoint(-away_B)) > kMayDip * body.radius()) return false;
  const double leastCosine = kFoot / std::hypot(kFoot, kHeight);
  return std::ranges::all_of(motion.outline(), [&](const PathPoint& p) {
    const PictureState state = motion.atPlayed(p.played_s);
    return (state.R_VB * away_B).dot(state.R_VW.col(2)) >= leastCosine;
  });
}

}  // namespace

bool standsOnPivot(const scene::Scene& scene) {
  return scene.body.pivot_B || !scene.motion.forcing.gravity_B.isZero(0);
}

StandFigure::StandFigure(const scene::Scene& scene, const PictureMotion& motion, const BodyFigure& body,
                         double scale)
    : bodyRadius_(scale * body.radius()), toCentre_B_(Vector3d::Zero()) {
  for (const Vector3d& direction : cubeDirections()) outer_B_.push_back(scale * body.supportPoint(direction));
  const Vector3d& gravity_B = scene.motion.forcing.gravity_B;
  hasPedestal_ = !gravity_B.isZero(0) && (lowestPoint_W(motion, body, scale) > -kMayDip * bodyRadius_ ||
                                          leavesRoomBelow(motion, body, gravity_B));
  const bool apart = body.gauge(Vector3d::Zero()) > 1.02;
  if (scene.body.mass && apart) toCentre_B_ = scale * (scene.body.mass->centre_B() - scene.body.fixedPoint_B());
}

std::vector<Vector3d> StandFigure::outermostPoints(const PictureState& state) const {
  std::vector<Vector3d> points;
  for (const Vector3d& p_B : outer_B_) points.emplace_back(state.R_VB * p_B);
  if (!hasPedestal_) return points;
  const Vector3d up_V = state.R_VW.col(2);
  for (const Vector3d& p : circleAbout(-kHeight * bodyRadius_ * up_V, up_V, kFoot * bodyRadius_, kFootRimPoints))
    points.push_back(p);
  return points;
}

void StandFigure::addRod(draw::DrawList& list, const PictureState& state, const Palette& colors) const {
  if (toCentre_B_.isZero(0)) return;
  list.frustums.push_back({glm::vec3(0),
                           toPicture(Vector3d(state.R_VB * toCentre_B_)),
                           static_cast<float>(kStandRod),
                           static_cast<float>(kStandRod),
                           {colors.rod, 0.35f}});
}

void StandFigure::add(draw::DrawList& list, const PictureState& state, const Palette& colors) const {
  addRod(list, state, colors);
  const Vector3d up_V = state.R_VW.col(2);
  if (hasPedestal_)
    list.frustums.push_back({toPicture(Vector3d(-kHeight * bodyRadius_ * up_V)),
                             glm::vec3(0),
                             static_cast<float>(kFoot * bodyRadius_),
                             static_cast<float>(kTip),
                             {colors.rod, 0.1f}});
  else
    list.ellipsoids.push_back({glm::vec3(0), glm::mat3(static_cast<float>(kJoint)), {colors.ink, 0.4f}});
}

}  // namespace poinsot::stage
