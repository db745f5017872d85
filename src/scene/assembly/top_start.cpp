// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/top_start.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "physics/heavy_top.h"
#include "scene/motion/heavy_top_start.h"

namespace poinsot::scene {
namespace {

using Eigen::Vector3d;
using physics::NutationKind;

std::string degrees(double angle_rad) { return fmt::format("{:.6g} deg", angle_rad * 180 / std::numbers::pi); }

/// Rate of the precession at the start of each kind of nutation, relative to the slow steady precession.
double startingPart(NutationKind kind) {
  if (kind == NutationKind::kCusps) return 0;
  return kind == NutationKind::kLoops ? -1 : 0.5;
}

class TopStart {
 public:
  TopStart(const StartDraft& start, const Body& body, const Motion& motion, Findings& findings)
      : start_(start), body_(body), motion_(motion), findings_(findings) {}

  std::optional<Vector3d> omega_B(const std::optional<Vector3d>& axis_B) {
    top_ = physics::heavyTop(body_.axes.moments(), body_.axes.toP(motion_.forcing.gravity_B), kMostUneven);
    if (!top_)
      return refused(motion_.forcing.gravity_B.isZero(0)
                         ? "needs gravity: give motion.gravity"
                         : "needs a symmetric body whose centre of mass lies on the axis of symmetry");
    const Vector3d up_P = body_.axes.toP(motion_.orientation_WB->conjugate() * Vector3d::UnitZ());
    tilt_rad_ = std::atan2(up_P.cross(top_->k_P).norm(), up_P.dot(top_->k_P));
    constexpr double kLeastTilt_rad = 1e-6;
    if (std::sin(tilt_rad_) < kLeastTilt_rad)
      return refused("needs a top that leans: its axis is vertical; give motion.lean, such as \"60 deg\"");
    if (axis_B && !spinsAboutItsAxis(*axis_B)) return std::nullopt;
    const auto spin =
        start_.precession ? top_->spinOfPrecession(tilt_rad_, *start_.precession) : sense_ * *start_.spin;
    const auto rate = start_.precession ? start_.precession : rateAtStart(spin);
    if (!rate) return std::nullopt;
    return body_.axes.toB(top_->omegaPrecessing(up_P, spin, *rate));
  }

 private:
  std::string_view path() const { return start_.nutation ? "motion.nutation" : "motion.precession"; }

  std::nullopt_t refused(const std::string& reason) {
    findings_.refuse(path(), reason);
    return std::nullopt;
  }

  bool spinsAboutItsAxis(const Vector3d& axis_B) {
    constexpr double kSame = 1e-9;
    const double along = body_.axes.toP(axis_B).dot(top_->k_P);
    sense_ = along < 0 ? -1 : 1;
    if (std::abs(std::abs(along) - 1) < kSame) return true;
    refused("needs a spin about the axis of symmetry; give another motion.spin_axis");
    return false;
  }

  /// Returns the rate of precession at the start, rad/s.
  std::optional<double> rateAtStart(double spin) {
    if (spin == 0) return refused("needs a spin; without it the body is a pendulum");
    if (start_.nutation == NutationKind::kCusps) return 0;
    const auto steady = top_->steadyPrecession(tilt_rad_, spin);
    if (!steady) return refused(tooSlow());
    if (start_.nutation) return startingPart(*start_.nutation) * steady->slow;
    if (*start_.steady == PrecessionWord::kSlow) return steady->slow;
    if (std::isfinite(steady->fast)) return steady->fast;
    return refused("has no fast precession, because the axis is level; give \"slow\", or another lean");
  }

  std::string tooSlow() const {
    const double least = 2 * std::sqrt(top_->across * top_->weight * std::cos(tilt_rad_)) / top_->along;
    return fmt::format(
        "needs a faster spin: a lean of {} precesses steadily only with |motion.spin| of at least "
        "{:.6g} rad/s ({:.4g} rev/s)",
        degrees(tilt_rad_), least, least / (2 * std::numbers::pi));
  }

  const StartDraft& start_;
  const Body& body_;
  const Motion& motion_;
  Findings& findings_;
  std::optional<physics::HeavyTop> top_;
  double tilt_rad_ = 0;
  double sense_ = 1;  ///< -1 if the axis of the spin points away from the centre of mass
};

}  // namespace

bool isTopStart(const StartDraft& start) { return start.steady || start.precession || start.nutation; }

std::optional<Vector3d> topOmega(const StartDraft& start, const Body& body, const Motion& motion,
                                 const std::optional<Vector3d>& axis_B, Findings& findings) {
  return TopStart(start, body, motion, findings).omega_B(axis_B);
}

}  // namespace poinsot::scene
