// SPDX-License-Identifier: Apache-2.0
#include "scene/motion/heavy_top_start.h"

#include <cmath>

#include "scene/motion/make_motion.h"

namespace poinsot::scene {
namespace {

constexpr double kNearly = 0.5;  // as kMostUneven, for a fast spin

bool gravityAlone(const physics::Forcing& forcing) {
  physics::Forcing rest = forcing;
  rest.gravity_B.setZero();
  return !forcing.none() && rest.none();
}

/// Returns the start of the heavy top if the body is nearly symmetric about an axis k; otherwise nothing.
/// @param most  largest relative difference of the two moments perpendicular to k; also the largest distance of
/// the centre of mass from k, relative to its distance from the fixed point
std::optional<HeavyTopStart> startOf(const Scene& scene, double most) {
  const physics::PrincipalAxes& axes = scene.body.axes;
  const auto top = physics::heavyTop(axes.moments(), axes.toP(scene.motion.forcing.gravity_B), most);
  if (!top) return std::nullopt;
  const Eigen::Vector3d acrossK = axes.moments().values() - top->along * top->k_P.cwiseAbs();
  const double uneven = 2 * (acrossK.maxCoeff() / top->across - 1);
  return HeavyTopStart{*top, axes.toP(scene.motion.omega_B),
                       axes.toP(startOrientation(scene).conjugate() * Eigen::Vector3d::UnitZ()), std::abs(uneven)};
}

}  // namespace

double HeavyTopStart::tilt_rad() const { return std::atan2(up_P.cross(top.k_P).norm(), up_P.dot(top.k_P)); }

double HeavyTopStart::spin() const { return omega_P.dot(top.k_P); }

std::optional<HeavyTopStart> heavyTopStart(const Scene& scene) {
  return gravityAlone(scene.motion.forcing) ? startOf(scene, kMostUneven) : std::nullopt;
}

std::optional<HeavyTopStart> nearlyHeavyTopStart(const Scene& scene) {
  physics::Forcing forcing = scene.motion.forcing;
  forcing.dragRate_P.setZero();
  forcing.dissipation = 0;
  if (!gravityAlone(forcing)) return std::nullopt;
  const auto start = startOf(scene, kNearly);
  const bool averages = start && std::abs(start->spin()) >= start->top.sleepingSpin();
  return averages ? start : startOf(scene, kMostUneven);
}

}  // namespace poinsot::scene
