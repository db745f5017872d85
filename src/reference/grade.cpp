// SPDX-License-Identifier: Apache-2.0
#include "reference/grade.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "core/error.h"
#include "core/expect.h"
#include "reference/grade_convention.h"
#include "reference/grade_shift.h"

namespace poinsot::reference {
namespace {

using Eigen::Vector3d;

constexpr double kUnitLength = 1e-6;  // tolerated error in the length of a quaternion with six digits
constexpr double kClose = 0.02;       // rms, rad or relative; with a larger one, a reading only "fits better"

/// Names of the columns from which each quantity is computed. Empty if the log lacks the columns.
struct Origins {
  std::string attitude, omega_B, omega_W, rate_B, rate_W, directionOfL, lengthOfL, kineticEnergy;
};

Origins originsOf(const LoggedState& theirs) {
  const bool q = theirs.q_WB.has_value(), wB = theirs.omega_B.has_value(), wW = theirs.omega_W.has_value(),
             L = theirs.L_W.has_value();
  const std::string body = wB ? "omega_B" : wW && q ? "omega_W, q" : "";
  Origins origins;
  if (q) origins.attitude = "q";
  if (wB) origins.omega_B = "omega_B";
  if (wW) origins.omega_W = "omega_W";
  if (theirs.rate_B) origins.rate_B = "rate_B";
  if (theirs.rate_W) origins.rate_W = "rate_W";
  origins.lengthOfL = L ? "L_W" : body;
  origins.directionOfL = L ? "L_W" : q && wB ? "omega_B, q" : wW && q ? body : "";
  origins.kineticEnergy = theirs.kineticEnergy ? "T" : body;
  return origins;
}

/// Comparison of a log with the motion, with some readings applied. Omits rows at times for which the motion is
/// unknown. The readings in use move no row with finite values to such a time (grade_convention.h).
class Comparison {
 public:
  Comparison(const KnownMotion& motion, const TrajectoryTable& theirs, std::vector<Reading> readings)
      : motion_(motion), theirs_(theirs), readings_(std::move(readings)) {
    sortRows();
    for (const std::size_t row : order_)
      if (const LoggedState state = stateOf(row); motion_.knows(state.t_s)) compare(oursAt(state.t_s, row), state);
  }

  std::vector<GradedQuantity> quantities();
  double firstTime_s() const { return t_s_.front(); }
  double lastTime_s() const { return t_s_.back(); }
  std::vector<std::string> valueNotes() const;

 private:
  void sortRows();
  LoggedState stateOf(std::size_t row) const;
  physics::RigidBodyState oursAt(double t_s, std::size_t row) const;
  void compare(const physics::RigidBodyState& ours, const LoggedState& theirs);
  void compareVectors(const physics::RigidBodyState& ours, const LoggedState& theirs);
  void compareMomenta(const physics::RigidBodyState& ours, const LoggedState& theirs);
  /// @param scale  number that divides the errors; 0 keeps the errors in `unit`
  GradedQuantity summary(std::string_view key, std::string_view label, std::string_view unit,
                         const std::string& from, std::vector<double>& errors, double scale) const;
  GradedQuantity signedSummary(std::string_view key, const std::string& from, std::vector<double>& differences,
                               double scale) const;

  const KnownMotion& motion_;
  const TrajectoryTable& theirs_;
  std::vector<Reading> readings_;
  std::vector<std::size_t> order_;
  std::vector<double> t_s_;
  std::vector<double> attitude_, omega_B_, omega_W_, rate_B_, rate_W_, directionOfL_;
  std::vector<double> lengthOfL_, kineticEnergy_;  // with their signs
  double largestOmega_ = 0, largestL_ = 0, largestT_ = 0;
  double worstLength_ = 0;  // largest | |q| - 1 | of the quaternions of the log
  std::vector<double> notFinite_s_;
};

void Comparison::sortRows() {
  order_.resize(theirs_.rows());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  const bool backwards = spanOf(theirs_).to_s <= 0;
  std::ranges::stable_sort(order_, [&](std::size_t a, std::size_t b) {
    return backwards ? theirs_.t_s(a) > theirs_.t_s(b) : theirs_.t_s(a) < theirs_.t_s(b);
  });
}

LoggedState Comparison::stateOf(std::size_t row) const { return readAs(loggedState(theirs_, row), readings_); }

double worst(double error) { return std::isfinite(error) ? error : std::numeric_limits<double>::infinity(); }

physics::RigidBodyState Comparison::oursAt(double t_s, std::size_t row) const {
  try {
    return motion_.at(t_s);
  } catch (const core::Error& error) {
    throw core::Error(error.kind(), error.message(), theirs_.placeOfTime(row));
  }
}

void Comparison::compare(const physics::RigidBodyState& ours, const LoggedState& theirs) {
  t_s_.push_back(theirs.t_s);
  if (!isFinite(theirs)) notFinite_s_.push_back(theirs.t_s);
  if (std::isfinite(theirs.quaternionLength) && theirs.quaternionLength > 0)
    worstLength_ = std::max(worstLength_, std::abs(theirs.quaternionLength - 1));
  if (theirs.q_WB) attitude_.push_back(worst(angleBetween(ours.q_WB, *theirs.q_WB)));
  compareVectors(ours, theirs);
  compareMomenta(ours, theirs);
}

std::vector<std::string> Comparison::valueNotes() const {
  std::vector<std::string> notes;
  if (worstLength_ > kUnitLength)
    notes.push_back(fmt::format(
        "lengths of quaternions differ from 1 by up to {:.2g}; they are graded as normalised", worstLength_));
  if (!notFinite_s_.empty())
    notes.push_back(
        fmt::format("{} of {} rows have a value that is not a number, or a quaternion of length 0; the "
                    "first is at t = {:.6g} s. Their errors count as infinite",
                    notFinite_s_.size(), theirs_.rows(), notFinite_s_.front()));
  return notes;
}

void Comparison::compareVectors(const physics::RigidBodyState& ours, const LoggedState& theirs) {
  largestOmega_ = std::max(largestOmega_, ours.omega_B.norm());
  const auto add = [](std::vector<double>& errors, const std::optional<Vector3d>& their, const Vector3d& our) {
    if (their) errors.push_back(worst((*their - our).norm()));
  };
  add(omega_B_, theirs.omega_B, ours.omega_B);
  add(omega_W_, theirs.omega_W, ours.omega_W);
  add(rate_B_, theirs.rate_B, physics::turningRate_B(motion_.motion(), ours));
  add(rate_W_, theirs.rate_W, physics::turningRate_W(motion_.motion(), ours));
}

void Comparison::compareMomenta(const physics::RigidBodyState& ours, const LoggedState& theirs) {
  const DerivedState their = derivedState(motion_.motion().axes(), theirs);
  largestL_ = std::max(largestL_, ours.L_W.norm());
  largestT_ = std::max(largestT_, ours.kineticEnergy);
  if (their.L_W) directionOfL_.push_back(worst(angleBetween(ours.L_W, *their.L_W)));
  if (their.lengthOfL) lengthOfL_.push_back(worst(*their.lengthOfL - ours.L_W.norm()));
  if (their.kineticEnergy) kineticEnergy_.push_back(worst(*their.kineticEnergy - ours.kineticEnergy));
}

double rootMeanSquare(const std::vector<double>& errors, double largest) {
  if (largest == 0 || !std::isfinite(largest)) return largest;
  double sum = 0;  // sum of (error / largest)^2; no term exceeds 1, so there is no overflow
  for (const double error : errors) sum += (error / largest) * (error / largest);
  return largest * std::sqrt(sum / static_cast<double>(errors.size()));
}

GradedQuantity Comparison::summary(std::string_view key, std::string_view label, std::string_view unit,
                                   const std::string& from, std::vector<double>& errors, double scale) const {
  if (errors.empty()) return {key, label, unit, from, std::nullopt};
  if (scale > 0) {
    unit = "1";
    for (double& error : errors) error /= scale;
  }
  const auto largest = std::ranges::max_element(errors);
  const double at_s = t_s_[static_cast<std::size_t>(largest - errors.begin())];
  return {key, label, unit, from,
          ErrorSummary{*largest, at_s, errors.back(), rootMeanSquare(errors, *largest), findDrift(t_s_, errors),
                       std::nullopt, Trend::kNone}};
}

/// Returns the sign that predominates in the last quarter of the rows, or kNone if neither sign does.
Trend trendOf(const std::vector<double>& differences) {
  double sum = 0, sizes = 0;
  for (std::size_t i = differences.size() - (differences.size() + 3) / 4; i < differences.size(); ++i) {
    sum += differences[i];
    sizes += std::abs(differences[i]);
  }
  if (!(std::abs(sum) > 0.5 * sizes)) return Trend::kNone;
  return sum < 0 ? Trend::kLoses : Trend::kGains;
}

GradedQuantity Comparison::signedSummary(std::string_view key, const std::string& from,
                                         std::vector<double>& differences, double scale) const {
  std::vector<double> errors;
  for (const double difference : differences) errors.push_back(std::abs(difference));
  GradedQuantity quantity = key == "T" ? summary(key, "T", "J", from, errors, scale)
                                       : summary(key, "|L|", "kg m^2/s", from, errors, scale);
  if (!quantity.errors) return quantity;
  quantity.errors->signedFinal = scale > 0 ? differences.back() / scale : differences.back();
  const DriftKind kind = quantity.errors->drift.kind;
  if (kind == DriftKind::kDrift || (kind == DriftKind::kTooFewRows && quantity.errors->final > kRoundingError))
    quantity.errors->trend = trendOf(differences);
  return quantity;
}

std::vector<GradedQuantity> Comparison::quantities() {
  const Origins from = originsOf(stateOf(0));
  std::vector<GradedQuantity> all = {
      summary("attitude", "attitude", "rad", from.attitude, attitude_, 0),
      summary("omega_B", "omega in the body", "rad/s", from.omega_B, omega_B_, largestOmega_),
      summary("omega_W", "omega in space", "rad/s", from.omega_W, omega_W_, largestOmega_),
      summary("direction_of_L", "direction of L", "rad", from.directionOfL, directionOfL_, 0),
      signedSummary("length_of_L", from.lengthOfL, lengthOfL_, largestL_),
      signedSummary("T", from.kineticEnergy, kineticEnergy_, largestT_),
  };
  if (motion_.motion().dissipation() == 0 && from.rate_B.empty() && from.rate_W.empty()) return all;
  all.push_back(summary("rate_B", "rate in the body", "rad/s", from.rate_B, rate_B_, largestOmega_));
  all.push_back(summary("rate_W", "rate in space", "rad/s", from.rate_W, rate_W_, largestOmega_));
  return all;
}

std::string causesText(const std::vector<FitCause>& causes) {
  std::string text;
  for (const FitCause& cause : causes)
    text += fmt::format("{}{} ({})", text.empty() ? "" : " and ", cause.condition, cause.remark);
  return text;
}

bool isOfState(const GradedQuantity& quantity) {
  return quantity.errors && (quantity.key == "attitude" || quantity.key.starts_with("omega"));
}

std::string largestErrors(const std::vector<GradedQuantity>& quantities) {
  std::string text;
  for (const GradedQuantity& quantity : quantities)
    if (isOfState(quantity))
      text += fmt::format("{}{} {:.1e}{}", text.empty() ? "" : ", ", quantity.label, quantity.errors->largest,
                          unitAfter(quantity));
  return text;
}

bool isClose(const Fit& fit) {
  return std::ranges::none_of(fit.quantities, [](const GradedQuantity& quantity) {
    return isOfState(quantity) && quantity.errors->rms > kClose;
  });
}

}  // namespace

std::string unitAfter(const GradedQuantity& quantity) {
  return quantity.unit == "1" ? "" : fmt::format(" {}", quantity.unit);
}

std::string fitNote(const Fit& fit) {
  return fmt::format("{} if {}: {}", isClose(fit) ? "fits" : "fits better", causesText(fit.causes),
                     largestErrors(fit.quantities));
}

std::string firstRowNote(const Fit& fit) {
  return isClose(fit) ? fitNote(fit) : "graded from its first row: " + largestErrors(fit.quantities);
}

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

Fit gradeFromZero(const MotionMaker& maker, const TrajectoryTable& theirs) {
  const physics::TimeSpan span = spanOf(theirs), wanted{0, span.to_s - span.from_s};
  const auto motion = maker(wanted);
  const KnownMotion known(*motion, wanted);
  const Reading reading = shiftReading(-span.from_s, span.from_s);
  return {{reading.cause}, Comparison(known, theirs, {reading}).quantities()};
}

Grade grade(const physics::Motion& motion, const TrajectoryTable& theirs, const MotionMaker& maker) {
  KnownMotion known(motion, spanOf(theirs));
  Comparison asWritten(known, theirs, {});
  Grade result{theirs.rows(), asWritten.firstTime_s(), asWritten.lastTime_s(), asWritten.quantities(), {}, {}};
  const std::vector<Reading> readings = fittingReadings(known, maker, theirs);
  if (!readings.empty()) {
    result.fit = Fit{{}, Comparison(known, theirs, readings).quantities()};
    for (const Reading& reading : readings) result.fit->causes.push_back(reading.cause);
    result.notes.push_back(fitNote(*result.fit));
  }
  std::ranges::move(asWritten.valueNotes(), std::back_inserter(result.notes));
  return result;
}

}  // namespace poinsot::reference
