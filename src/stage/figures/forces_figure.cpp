// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/forces_figure.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/expect.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kForceRadius = 0.019;
constexpr double kLongestForce = 0.75;
constexpr double kInwards = 1e-9;  // smallest sine of the angle by which a force leads into the body

constexpr double kArmRadius = 0.012;
constexpr double kNameOfArm = 0.55;
constexpr double kArmDashes = 1.4;

std::string armName(std::size_t i, std::size_t count) {
  return count == 1 ? "$\\mathbf{r}$" : fmt::format("$\\mathbf{{r}}_{{{}}}$", i + 1);
}

double sizeOf(const physics::PointForce& force) { return force.force_B.norm() + force.force_W.norm(); }

}  // namespace

ForcesFigure::ForcesFigure(const Setting& setting)
    : arms_(setting.scene.show.figures.forces.arms), extent_(2 * setting.scales.reach) {
  const scene::Motion& motion = setting.scene.motion;
  double largest = 0;
  for (const physics::PointForce& force : motion.forcing.forces) largest = std::max(largest, sizeOf(force));
  std::vector<PictureState> states;
  for (const PathPoint& p : setting.motion.outline()) states.push_back(setting.motion.atPlayed(p.played_s));
  const double scale = largest > 0 ? kLongestForce * setting.scene.show.figures.forces.scale / largest : 0;
  for (std::size_t i = 0; i < motion.forcing.forces.size(); ++i) {
    const physics::PointForce& force = motion.forcing.forces[i];
    Drawn drawn{setting.scales.body * force.lever_B,
                scale * force.force_B,
                scale * force.force_W,
                force.from_s,
                force.to_s,
                false,
                motion.forceNames[i],
                armName(i, motion.forcing.forces.size())};
    drawn.endsAtPoint = leadsInwards(setting, states, drawn);
    forces_.push_back(std::move(drawn));
  }
}

Vector3d ForcesFigure::along_V(const Drawn& force, const PictureState& state) const {
  return state.R_VB * force.force_B + state.R_VW * force.force_W;
}

/// Returns whether a force points towards the centre of mass when it begins. The arrow keeps its end at the point
/// while the body turns, so that it does not jump.
bool ForcesFigure::leadsInwards(const Setting& setting, const std::vector<PictureState>& states,
                                const Drawn& force) const {
  const scene::Body& body = setting.scene.body;
  const Vector3d centre_B = body.mass ? Vector3d(body.mass->centre_B() - body.fixedPoint_B()) : Vector3d::Zero();
  const Vector3d outwards_B = force.point_B - setting.scales.body * centre_B;
  for (const PictureState& state : states) {
    if (!(force.from_s <= state.t_s && state.t_s < force.to_s)) continue;
    const Vector3d along = along_V(force, state);
    return along.dot(state.R_VB * outwards_B) < -kInwards * along.norm() * outwards_B.norm();
  }
  return false;
}

bool ForcesFigure::acts(std::size_t i, const PictureState& state) const {
  POINSOT_EXPECT(i < forces_.size());
  return forces_[i].from_s <= state.t_s && state.t_s < forces_[i].to_s;
}

ForcesFigure::Arrow ForcesFigure::arrow(std::size_t i, const PictureState& state) const {
  POINSOT_EXPECT(i < forces_.size());
  const Drawn& force = forces_[i];
  const Vector3d point = state.R_VB * force.point_B, along = along_V(force, state);
  if (force.endsAtPoint) return {point - along, point, true};
  return {point, point + along, false};
}

void ForcesFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const Arrow arrow = this->arrow(i, state);
    if (!acts(i, state) || (arrow.tip_V - arrow.from_V).isZero(0)) continue;
    canvas.arrowFrom(arrow.from_V, arrow.tip_V, kForceRadius, canvas.colors.torque);
    const Vector3d& point = arrow.endsAtPoint ? arrow.tip_V : arrow.from_V;
    canvas.label(forces_[i].name, arrow.endsAtPoint ? arrow.from_V : arrow.tip_V, point, canvas.colors.torque);
    if (arms_) addArm(canvas, forces_[i], state);
  }
}

void ForcesFigure::addArm(const Canvas& canvas, const Drawn& force, const PictureState& state) const {
  const Vector3d tip = state.R_VB * force.point_B, middle = kNameOfArm * tip;
  if (tip.isZero(0)) return;
  canvas.arrow(tip, kArmRadius, canvas.colors.ink);
  canvas.dashes(Vector3d::Zero(), tip, canvas.colors.ink, kArmDashes, extent_);  // for the part in the body
  canvas.label(force.armName, middle, middle + along_V(force, state), canvas.colors.ink);
}

std::vector<Vector3d> ForcesFigure::outermostPoints(const PictureState& state) const {
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const Arrow arrow = this->arrow(i, state);
    points.insert(points.end(), {arrow.from_V, arrow.tip_V});
  }
  return points;
}

}  // namespace poinsot::stage
