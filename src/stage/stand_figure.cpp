// SPDX-License-Identifier: Apache-2.0
#include "stage/stand_figure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kInstants = 240;  // of the film, at which the body's place is looked at
// In picture lengths, a table's radius in the body's.
constexpr double kTableRadius = 0.42, kTableThickness = 0.045, kJoint = 0.032, kRod = 0.012;
constexpr double kMayDip = 0.01;  // under the table's top, of the body's radius: an apex is a point only on paper

/// The body's farthest points in the directions of the picture's cube, at every instant, each with the inertial
/// height of its point.
struct Sweep {
  std::vector<Vector3d> points_V;
  double lowest_W = 0;

  Sweep(const PictureMotion& motion, const BodyFigure& body, double scale) {
    std::vector<Vector3d> outer_B;
    for (const Vector3d& direction : cubeDirections()) outer_B.push_back(scale * body.supportPoint(direction));
    for (int i = 0; i <= kInstants; ++i) {
      const PictureState state = motion.at(motion.duration_s() * i / kInstants);
      for (const Vector3d& p_B : outer_B) points_V.emplace_back(state.R_VB * p_B);
      const Vector3d down_B = -state.R_VB.transpose() * state.R_VW.col(2);
      lowest_W = std::min(lowest_W, -scale * down_B.dot(body.supportPoint(down_B)));
    }
  }
};

}  // namespace

bool standsOnPivot(const scene::Scene& scene) {
  return scene.body.pivot_B || !scene.motion.forcing.gravity_B.isZero(0);
}

StandFigure::StandFigure(const scene::Scene& scene, const PictureMotion& motion, const BodyFigure& body,
                         double scale)
    : tableRadius_(kTableRadius * scale * body.radius()), toCentre_B_(Vector3d::Zero()) {
  const Sweep sweep(motion, body, scale);
  outermostPoints_ = sweep.points_V;
  const bool gravity = !scene.motion.forcing.gravity_B.isZero(0);
  hasTable_ = gravity && sweep.lowest_W > -kMayDip * scale * body.radius();
  const bool apart = body.gauge(Vector3d::Zero()) > 1.02;
  if (scene.body.mass && apart) toCentre_B_ = scale * (scene.body.mass->centre_B() - scene.body.fixedPoint_B());
  if (!hasTable_) return;
  for (int i = 0; i < 12; ++i) {
    const double angle = std::numbers::pi * i / 6;
    outermostPoints_.emplace_back(tableRadius_ * std::cos(angle), tableRadius_ * std::sin(angle),
                                  -kTableThickness);
  }
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
