// SPDX-License-Identifier: Apache-2.0
#include "physics/rolling_cone.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "physics/euler_angles.h"
#include "physics/require_finite.h"
#include "physics/rotor.h"
#include "physics/solid_check.h"
#include "physics/transcendental.h"

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

constexpr double kUneven = 1e-9;  // accepted relative difference of the moments across the axis

Rotor<double> rotorOf(const Quaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }

/// Returns the rotation by `rate` times `t_s` about a unit vector, whose phase is exact to rounding.
Rotor<double> turnAbout(const Vector3d& axis, const DoubleDouble& rate, double t_s) {
  const DoubleDouble phase = rate * DoubleDouble(t_s);
  if (!(std::abs(phase.hi) <= kFarthestPhase_rad)) refuseTime(t_s);
  const SineCosine half = sineCosine(reduced(phase, kTwoPi * 2.0).rest * 0.5);
  return {half.cosine, half.sine * axis[0], half.sine * axis[1], half.sine * axis[2]};
}

void requireRollable(const PrincipalAxes& axes, const RollingCone& cone) {
  requirePositive(cone.radius_m, "the radius of a rolling cone's base");
  requirePositive(cone.height_m, "the height of a rolling cone");
  requireFinite(cone.rate, "the rate of a rolling cone", " rad/s");
  if (cone.rate == 0) throw core::physicsError("the rate of a rolling cone must not be 0");
  if (!(std::isfinite(cone.spin()) && std::isfinite(cone.alongContact())))
    throw core::physicsError(
        fmt::format("the half-angle of a rolling cone must be between 0 and 90 deg, and not too near to them; its "
                    "base has the radius {:g} m at the height {:g} m",
                    cone.radius_m, cone.height_m));
  const Eigen::Matrix3d inertia_B = axes.inertia_B();
  const Vector3d bent = inertia_B * cone.axis_B - cone.along * cone.axis_B;
  const Eigen::Matrix3d even = cone.across * Eigen::Matrix3d::Identity() +
                               (cone.along - cone.across) * cone.axis_B * cone.axis_B.transpose();
  const double uneven = std::max(bent.norm(), (inertia_B - even).norm()) / axes.moments().values().maxCoeff();
  if (!(uneven <= kUneven))
    throw core::physicsError(fmt::format(
        "this cone does not roll uniformly: its moments about the apex are not those of a body of "
        "revolution about the cone's axis; they differ by {:.3g} of the largest moment, and at most {:g} "
        "is allowed",
        uneven, kUneven));
}

}  // namespace

double RollingCone::slant_m() const { return std::sqrt(radius_m * radius_m + height_m * height_m); }
double RollingCone::sinAlpha() const { return radius_m / slant_m(); }
double RollingCone::cosAlpha() const { return height_m / slant_m(); }
double RollingCone::halfAngle_rad() const { return arcTangent(radius_m / height_m); }

double RollingCone::kineticEnergy() const {
  const double w = alongContact(), c = w * cosAlpha(), s = w * sinAlpha();
  return 0.5 * (along * c * c + across * s * s);
}

// L = I_t omega + (I_a - I_t)(omega·a) a
Vector3d RollingCone::angularMomentum() const {
  const double w = alongContact(), c = cosAlpha(), s = sinAlpha();
  return {w * (across * s * s + along * c * c), 0, w * (along - across) * c * s};
}

double RollingCone::torque() const { return rate * angularMomentum()[0]; }

Quaternion RollingCone::q_WB(double t_s) const {
  const Vector3d up = Vector3d::UnitZ();
  const Quaternion start = leaningAttitude(axis_B, toDouble(kHalfPi) - halfAngle_rad());
  const DoubleDouble slant = sqrt(DoubleDouble(radius_m) * radius_m + DoubleDouble(height_m) * height_m);
  const DoubleDouble aboutAxis = DoubleDouble(-rate) * slant / DoubleDouble(radius_m);
  const Rotor<double> q =
      normalized(turnAbout(up, rate, t_s) * rotorOf(start) * turnAbout(axis_B, aboutAxis, t_s));
  return q.w < 0 ? Quaternion(-q.w, -q.x, -q.y, -q.z) : Quaternion(q.w, q.x, q.y, q.z);
}

Vector3d RollingCone::contact_W(double t_s) const {
  const auto e = rotated(turnAbout(Vector3d::UnitZ(), rate, t_s), std::array{0.0, -1.0, 0.0});
  return {e[0], e[1], 0};
}

RollingCone rollingCone(const PrincipalAxes& axes, const Vector3d& axis_B, double radius_m, double height_m,
                        double rate) {
  requireFinite(axis_B, "the axis of a rolling cone");
  RollingCone cone;
  cone.axis_B = axis_B.stableNormalized();
  if (!(cone.axis_B.norm() > 0.5)) throw core::physicsError("the axis of a rolling cone must not be zero");
  cone.radius_m = radius_m;
  cone.height_m = height_m;
  cone.rate = rate;
  const Eigen::Matrix3d inertia_B = axes.inertia_B();
  cone.along = cone.axis_B.dot(inertia_B * cone.axis_B);
  cone.across = 0.5 * (inertia_B.trace() - cone.along);
  requireRollable(axes, cone);
  return cone;
}

RollingForces rollingForces(const RollingCone& cone, double mass_kg, double centre_m, double g) {
  requirePositive(mass_kg, "the mass of a rolling cone");
  requirePositive(centre_m, "the distance of a rolling cone's centre of mass from its apex");
  requirePositive(g, "the acceleration of gravity");
  RollingForces forces;
  forces.normal_N = mass_kg * g;
  const double atRest_m = centre_m * cone.cosAlpha(), perRate2_m = -cone.torque() / forces.normal_N;
  forces.place_m = atRest_m + perRate2_m;
  forces.inward_N = mass_kg * cone.rate * cone.rate * atRest_m;
  const double room_m = std::max(0.0, cone.slant_m() - atRest_m);
  forces.fastest = std::abs(cone.rate) * std::sqrt(room_m / perRate2_m);
  return forces;
}

RigidBodyState RollingMotion::at(double t_s) const {
  if (!std::isfinite(t_s)) refuseTime(t_s);
  RigidBodyState state;
  state.t_s = t_s;
  state.q_WB = cone_.q_WB(t_s);
  state.omega_W = cone_.alongContact() * cone_.contact_W(t_s);
  state.omega_B = rotated(state.q_WB.conjugate(), state.omega_W);
  const Vector3d along_W = cone_.contact_W(t_s), L = cone_.angularMomentum();
  state.L_W = L[0] * along_W + L[2] * Vector3d::UnitZ();
  state.kineticEnergy = cone_.kineticEnergy();
  return state;
}

Vector3d RollingMotion::torque_W(double t_s) const {
  const Vector3d e = cone_.contact_W(t_s);
  return cone_.torque() * Vector3d(-e[1], e[0], 0);
}

}  // namespace poinsot::physics
