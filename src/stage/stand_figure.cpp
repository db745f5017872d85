// SPDX-License-Identifier: Apache-2.0
#include "stage/stand_figure.h"

#include <algorithm>
#include <cmath>

#include "stage/actor.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

// In picture lengths, a table's radius in the body's.
constexpr double kTableRadius = 0.42, kTableThickness = 0.045, kJoint = 0.032, kRod = 0.012;
constexpr int kRimPoints = 12;    // of the table, to be framed
constexpr double kMayDip = 0.01;  // under the table's top, of the body's radius: an apex is a point only on paper

/// Inertial height of the body's lowest point over the whole film.
double lowestPoint_W(const PictureMotion& motion, const BodyFigure& body, double scale) {
  double lowest = 0;
  for (const PathPoint& p : motion.outline()) {
    const PictureState state = motion.at(p.filmTime_s);
    const Vector3d down_B = -state.R_VB.transpose() * state.R_VW.col(2);
    lowest = std::min(lowest, -scale * down_B.dot(body.supportPoint(down_B)));
  }
  return lowest;
}

}  // namespace

bool standsOnPivot(const scene::Scene& scene) {
  return scene.body.pivot_B || !scene.motion.forcing.gravity_B.isZero(0);
}

StandFigure::StandFigure(const scene::Scene& scene, const PictureMotion& motion, const BodyFigure& body,
                         double scale)
    : tableRadius_(kTableRadius * scale * body.radius()), toCentre_B_(Vector3d::Zero()) {
  for (const Vector3d& direction : cubeDirections()) outer_B_.push_back(scale * body.supportPoint(direction));
  const bool gravity = !scene.motion.forcing.gravity_B.isZero(0);
  hasTable_ = gravity && lowestPoint_W(motion, body, scale) > -kMayDip * scale * body.radius();
  const bool apart = body.gauge(Vector3d::Zero()) > 1.02;
  if (scene.body.mass && apart) toCentre_B_ = scale * (scene.body.mass->centre_B() - scene.body.fixedPoint_B());
}

std::vector<Vector3d> StandFigure::outermostPoints(const PictureState& state) const {
  std::vector<Vector3d> points;
  for (const Vector3d& p_B : outer_B_) points.emplace_back(state.R_VB * p_B);
  if (!hasTable_) return points;
  const Vector3d up_V = state.R_VW.col(2);
  for (const Vector3d& p : circleAbout(-kTableThickness * up_V, up_V, tableRadius_, kRimPoints))
    points.push_back(p);
  return points;
}

void StandFigure::addRod(draw::DrawList& list, const PictureState& state, const Palette& colors) const {
  if (toCentre_B_.isZero(0)) return;
  list.frustums.push_back({glm::vec3(0),
                           toPicture(Vector3d(state.R_VB * toCentre_B_)),
                           static_cast<float>(kRod),
                           static_cast<float>(kRod),
                           {colors.rod, 0.35f}});
}

void StandFigure::add(draw::DrawList& list, const PictureState& state, const Palette& colors) const {
  addRod(list, state, colors);
  const Vector3d up_V = state.R_VW.col(2);
  if (hasTable_)
    list.frustums.push_back({toPicture(Vector3d(-kTableThickness * up_V)),
                             glm::vec3(0),
                             static_cast<float>(tableRadius_),
                             static_cast<float>(tableRadius_),
                             {colors.rod, 0.1f}});
  else
    list.ellipsoids.push_back({glm::vec3(0), glm::mat3(static_cast<float>(kJoint)), {colors.ink, 0.4f}});
}

}  // namespace poinsot::stage
