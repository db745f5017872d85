// SPDX-License-Identifier: Apache-2.0
#include "app/grade_convention.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace poinsot::app {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr std::size_t kFewRows = 3;    // fit by chance
constexpr double kWrong = 0.02;        // rad, or of omega: nobody takes that for rounding
constexpr double kFarBetter = 0.05;    // of the misfit as it was read
constexpr double kTurned_rad = 0.001;  // less is no choice of axes

/// The square of the angle between two attitudes where it is small; grows with it elsewhere.
double squaredAngle(const Quaterniond& a, const Quaterniond& b) {
  return 8 * std::max(0., 1 - std::abs(a.dot(b)));
}

double angleOf(const Quaterniond& turn) { return 2 * std::atan2(turn.vec().norm(), std::abs(turn.w())); }

std::string turnText(const Quaterniond& turn) {
  const Vector3d axis = (turn.w() < 0 ? -1 : 1) * turn.vec().normalized();
  return fmt::format("{:.4g} deg about ({:.3g}, {:.3g}, {:.3g})", angleOf(turn) * 180 / EIGEN_PI, axis[0] + 0.,
                     axis[1] + 0., axis[2] + 0.);
}

}  // namespace

void ConventionSearch::Misfit::add(double squared) {
  sum += squared;
  ++count;
}

double ConventionSearch::Misfit::rms() const { return std::sqrt(sum / static_cast<double>(count)); }

bool ConventionSearch::Misfit::muchLessThan(const Misfit& asRead) const {
  return asRead.count >= kFewRows && asRead.rms() > kWrong && rms() < kFarBetter * asRead.rms();
}

Quaterniond ConventionSearch::read(Reading reading, const Quaterniond& q) const {
  switch (reading) {
    case kScalarLast:
      return {q.z(), q.w(), q.x(), q.y()};
    case kConjugate:
      return q.conjugate();
    case kScalarLastConjugate:
      return read(kScalarLast, q).conjugate();
    case kBodyTurned:
      return q * *bodyTurn_;
    case kSpaceTurned:
      return *spaceTurn_ * q;
    case kAsRead:
    case kReadings:
      break;
  }
  return q;
}

void ConventionSearch::addAttitude(const Quaterniond& ours, const Quaterniond& theirs) {
  if (!theirs.coeffs().allFinite()) return;
  if (!bodyTurn_) {
    bodyTurn_ = theirs.conjugate() * ours;
    spaceTurn_ = ours * theirs.conjugate();
  }
  for (int reading = kAsRead; reading < kReadings; ++reading)
    attitude_[static_cast<std::size_t>(reading)].add(
        squaredAngle(ours, read(static_cast<Reading>(reading), theirs)));
}

void ConventionSearch::addOmega(const Vector3d& ours, const Vector3d& other, const Vector3d& theirs) {
  const double size = ours.squaredNorm();
  if (!theirs.allFinite() || size == 0) return;
  omega_.add((theirs - ours).squaredNorm() / size);
  omegaInOtherFrame_.add((theirs - other).squaredNorm() / size);
  omegaInDegrees_.add((EIGEN_PI / 180 * theirs - ours).squaredNorm() / size);
  omegaInRpm_.add((EIGEN_PI / 30 * theirs - ours).squaredNorm() / size);
}

std::string ConventionSearch::attitudeHint() const {
  const auto best = std::ranges::min_element(attitude_, {}, [](const Misfit& misfit) { return misfit.sum; });
  if (!best->muchLessThan(attitude_[kAsRead])) return "";
  switch (static_cast<Reading>(best - attitude_.begin())) {
    case kScalarLast:
      return "the attitudes fit if q_w, q_x, q_y, q_z hold x, y, z, w: name the columns q_x, q_y, q_z, q_w";
    case kConjugate:
      return "the attitudes fit if q is conjugated: poinsot's q takes components along the body's axes to those "
             "in space";
    case kScalarLastConjugate:
      return "the attitudes fit if q_w, q_x, q_y, q_z hold x, y, z, w of the conjugate";
    case kBodyTurned:
      return turnHint("the body's axes", *bodyTurn_);
    case kSpaceTurned:
      return turnHint("the axes of space", *spaceTurn_);
    case kAsRead:
    case kReadings:
      break;
  }
  return "";
}

std::string ConventionSearch::turnHint(std::string_view axes, const Quaterniond& turn) {
  if (angleOf(turn) < kTurned_rad) return "";
  return fmt::format("the attitudes fit if {} are turned by {}: are they the scene's?", axes, turnText(turn));
}

std::string ConventionSearch::omegaHint() const {
  if (omegaInOtherFrame_.muchLessThan(omega_))
    return "omega fits the columns of the other frame: omega_B is along the body's axes, omega_W along those of "
           "space";
  if (omegaInDegrees_.muchLessThan(omega_)) return "omega fits in deg/s: its columns are in rad/s";
  if (omegaInRpm_.muchLessThan(omega_)) return "omega fits in rpm: its columns are in rad/s";
  return "";
}

std::vector<std::string> ConventionSearch::hints() const {
  std::vector<std::string> hints;
  if (bodyTurn_)
    if (std::string hint = attitudeHint(); !hint.empty()) hints.push_back(std::move(hint));
  if (std::string hint = omegaHint(); !hint.empty()) hints.push_back(std::move(hint));
  return hints;
}

}  // namespace poinsot::app
