// SPDX-License-Identifier: Apache-2.0
#include "app/grade.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "app/grade_convention.h"
#include "core/expect.h"

namespace poinsot::app {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kUnitLength = 1e-6;  // a quaternion printed with six digits is as near to unit length

/// What they say of one time, read or worked out.
struct TheirState {
  std::optional<Quaterniond> q_WB;
  std::optional<Vector3d> omega_B, omega_W, L_W;
  std::optional<double> lengthOfL, kineticEnergy;
};

/// Which columns each quantity comes from; empty: none.
struct Origins {
  std::string attitude, omega_B, omega_W, directionOfL, lengthOfL, kineticEnergy;
};

Origins originsOf(const TrajectoryTable& theirs) {
  const bool q = theirs.has(kQAt), wB = theirs.has(kOmegaBAt), wW = theirs.has(kOmegaWAt), L = theirs.has(kLWAt);
  const std::string body = wB ? "omega_B" : wW && q ? "omega_W, q" : "";
  Origins origins;
  if (q) origins.attitude = "q";
  if (wB) origins.omega_B = "omega_B";
  if (wW) origins.omega_W = "omega_W";
  origins.lengthOfL = L ? "L_W" : body;
  origins.directionOfL = L ? "L_W" : q && wB ? "omega_B, q" : wW && q ? body : "";
  origins.kineticEnergy = theirs.has(kEnergyAt) ? "T" : body;
  return origins;
}

class Comparison {
 public:
  Comparison(const physics::Motion& motion, const TrajectoryTable& theirs) : motion_(motion), theirs_(theirs) {
    sortRows();
    for (const std::size_t row : order_) compare(row);
  }

  Grade grade();

 private:
  void sortRows();
  void compare(std::size_t row);
  TheirState stateOf(std::size_t row);
  Vector3d vectorAt(std::size_t row, TrajectoryPlace place) const {
    return {theirs_.at(row, place), theirs_.at(row, place + 1), theirs_.at(row, place + 2)};
  }
  std::optional<Quaterniond> attitudeAt(std::size_t row);
  GradedQuantity summary(std::string_view key, std::string_view label, std::string_view unit,
                         const std::string& from, std::vector<double>& errors, double scale) const;

  const physics::Motion& motion_;
  const TrajectoryTable& theirs_;
  std::vector<std::size_t> order_;
  std::vector<double> t_s_;
  std::vector<double> attitude_, omega_B_, omega_W_, directionOfL_, lengthOfL_, kineticEnergy_;
  double largestOmega_ = 0, largestL_ = 0, largestT_ = 0;
  double worstLength_ = 0;  // of a quaternion, off 1
  ConventionSearch conventions_;
};

void Comparison::sortRows() {
  order_.resize(theirs_.rows());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  const bool backwards = spanOf(theirs_).to_s <= 0;
  std::ranges::stable_sort(order_, [&](std::size_t a, std::size_t b) {
    return backwards ? theirs_.t_s(a) > theirs_.t_s(b) : theirs_.t_s(a) < theirs_.t_s(b);
  });
  for (const std::size_t row : order_) t_s_.push_back(theirs_.t_s(row));
}

std::optional<Quaterniond> Comparison::attitudeAt(std::size_t row) {
  if (!theirs_.has(kQAt)) return std::nullopt;
  const Quaterniond q(theirs_.at(row, kQAt), theirs_.at(row, kQAt + 1), theirs_.at(row, kQAt + 2),
                      theirs_.at(row, kQAt + 3));
  const double length = q.coeffs().stableNorm();
  if (std::isfinite(length)) worstLength_ = std::max(worstLength_, std::abs(length - 1));
  return Quaterniond(q.coeffs() / length);  // not a number where there is no direction
}

TheirState Comparison::stateOf(std::size_t row) {
  const physics::PrincipalAxes& axes = motion_.axes();
  TheirState s;
  s.q_WB = attitudeAt(row);
  if (theirs_.has(kOmegaBAt)) s.omega_B = vectorAt(row, kOmegaBAt);
  if (theirs_.has(kOmegaWAt)) s.omega_W = vectorAt(row, kOmegaWAt);
  std::optional<Vector3d> body = s.omega_B;
  if (!body && s.omega_W && s.q_WB) body = s.q_WB->conjugate() * *s.omega_W;
  if (body) {
    const Vector3d m_B = axes.angularMomentum(*body);
    s.lengthOfL = m_B.norm();
    s.kineticEnergy = 0.5 * body->dot(m_B);
    if (s.q_WB) s.L_W = *s.q_WB * m_B;
  }
  if (theirs_.has(kLWAt)) {
    s.L_W = vectorAt(row, kLWAt);
    s.lengthOfL = s.L_W->norm();
  }
  if (theirs_.has(kEnergyAt)) s.kineticEnergy = theirs_.at(row, kEnergyAt);
  return s;
}

/// What is not finite is as wrong as can be.
double worst(double error) { return std::isfinite(error) ? error : std::numeric_limits<double>::infinity(); }

double angleBetween(const Quaterniond& a, const Quaterniond& b) {
  const Quaterniond d = a.conjugate() * b;
  return 2 * std::atan2(d.vec().norm(), std::abs(d.w()));
}

double angleBetween(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

void Comparison::compare(std::size_t row) {
  const physics::RigidBodyState ours = motion_.at(theirs_.t_s(row));
  const TheirState their = stateOf(row);
  largestOmega_ = std::max(largestOmega_, ours.omega_B.norm());
  largestL_ = std::max(largestL_, ours.L_W.norm());
  largestT_ = std::max(largestT_, ours.kineticEnergy);
  if (their.q_WB) conventions_.addAttitude(ours.q_WB, *their.q_WB);
  if (their.omega_B)
    conventions_.addOmega(ours.omega_B, ours.omega_W, *their.omega_B);
  else if (their.omega_W)
    conventions_.addOmega(ours.omega_W, ours.omega_B, *their.omega_W);
  if (their.q_WB) attitude_.push_back(worst(angleBetween(ours.q_WB, *their.q_WB)));
  if (their.omega_B) omega_B_.push_back(worst((*their.omega_B - ours.omega_B).norm()));
  if (their.omega_W) omega_W_.push_back(worst((*their.omega_W - ours.omega_W).norm()));
  if (their.L_W) directionOfL_.push_back(worst(angleBetween(ours.L_W, *their.L_W)));
  if (their.lengthOfL) lengthOfL_.push_back(worst(std::abs(*their.lengthOfL - ours.L_W.norm())));
  if (their.kineticEnergy) kineticEnergy_.push_back(worst(std::abs(*their.kineticEnergy - ours.kineticEnergy)));
}

double rootMeanSquare(const std::vector<double>& errors, double largest) {
  if (largest == 0 || !std::isfinite(largest)) return largest;
  double sum = 0;  // of squares at most 1: none overflows or vanishes
  for (const double error : errors) sum += (error / largest) * (error / largest);
  return largest * std::sqrt(sum / static_cast<double>(errors.size()));
}

GradedQuantity Comparison::summary(std::string_view key, std::string_view label, std::string_view unit,
                                   const std::string& from, std::vector<double>& errors, double scale) const {
  if (errors.empty()) return {key, label, unit, from, std::nullopt};
  if (scale > 0)
    for (double& error : errors) error /= scale;
  const auto largest = std::ranges::max_element(errors);
  const double at_s = t_s_[static_cast<std::size_t>(largest - errors.begin())];
  return {key, label, unit, from,
          ErrorSummary{*largest, at_s, errors.back(), rootMeanSquare(errors, *largest), findDrift(t_s_, errors)}};
}

Grade Comparison::grade() {
  const Origins from = originsOf(theirs_);
  Grade result{t_s_.size(), t_s_.front(), t_s_.back(), {}, {}};
  result.quantities = {
      summary("attitude", "attitude", "rad", from.attitude, attitude_, 1),
      summary("omega_B", "omega in the body", "1", from.omega_B, omega_B_, largestOmega_),
      summary("omega_W", "omega in space", "1", from.omega_W, omega_W_, largestOmega_),
      summary("direction_of_L", "direction of L", "rad", from.directionOfL, directionOfL_, 1),
      summary("length_of_L", "|L|", "1", from.lengthOfL, lengthOfL_, largestL_),
      summary("T", "T", "1", from.kineticEnergy, kineticEnergy_, largestT_),
  };
  if (worstLength_ > kUnitLength)
    result.notes.push_back(
        fmt::format("quaternions are off unit length by up to {:.2g}; graded as normalised", worstLength_));
  for (std::string& hint : conventions_.hints()) result.notes.push_back(std::move(hint));
  return result;
}

}  // namespace

const GradedQuantity& Grade::quantity(std::string_view key) const {
  const auto found = std::ranges::find(quantities, key, &GradedQuantity::key);
  POINSOT_EXPECT(found != quantities.end());
  return *found;
}

physics::TimeSpan spanOf(const TrajectoryTable& theirs) {
  physics::TimeSpan span{theirs.t_s(0), theirs.t_s(0)};
  for (std::size_t row = 1; row < theirs.rows(); ++row) {
    span.from_s = std::min(span.from_s, theirs.t_s(row));
    span.to_s = std::max(span.to_s, theirs.t_s(row));
  }
  return span;
}

Grade grade(const physics::Motion& motion, const TrajectoryTable& theirs) {
  return Comparison(motion, theirs).grade();
}

}  // namespace poinsot::app
