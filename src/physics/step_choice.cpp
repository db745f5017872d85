// SPDX-License-Identifier: Apache-2.0
#include "physics/step_choice.h"

#include <algorithm>
#include <cmath>

#include "physics/transcendental.h"

namespace poinsot::physics {
namespace {

constexpr int kSamples = 200;  // number of times at which two runs are compared, on each side of time 0
// Smallest factor by which one attempt shortens the steps. The factor follows from the difference of two runs. If
// the steps are still long, this difference does not yet shrink with the step as the method's order predicts.
constexpr double kShrinkMost = 0.125;
/// A difference of two runs below this angle shrinks with the step as the order of the method predicts. If it does
/// not shrink, it is due to rounding.
constexpr double kAsymptotic_rad = 1e-3;
constexpr double kWorthless = 1e-18;  // local error below which shorter steps are useless; far below rounding
// Rounding error that runs with any step length may have in common, as a fraction of the turned angle. Measured
// after 1400 rad for free bodies: 0.1 to 3.8 times this value, mostly below 1. After 2e4 rad for the heavy top:
// 0.3 times.
constexpr double kCommonRounding = 0x1p-53;

double angleBetween(const DrivenState& a, const DrivenState& b) {
  const Rotor<double> turn = conjugate(toDouble(a.q_WP)) * toDouble(b.q_WP);
  const double sine = norm({turn.x, turn.y, turn.z});
  return 2 * arcTangent(sine / std::abs(turn.w));
}

double largestAngle(const DrivenTrajectory& a, const DrivenTrajectory& b) {
  double largest = 0;
  for (int i = 1; i <= kSamples; ++i) {
    const double t = i == kSamples ? a.end_s() : a.end_s() / kSamples * i;
    largest = std::max(largest, angleBetween(a.at(t), b.at(t)));
  }
  return largest;
}

double power(double x, int n) {
  double result = 1;
  for (int i = 0; i < n; ++i) result *= x;
  return result;
}

/// Returns the n-th root of `bound`, rounded down to 1 or a power of 0.95, or `least` if that is larger. Uses no
/// logarithm.
double rootBelow(double bound, int n, double least) {
  double root = 1;
  while (root > least && power(root, n) > bound) root *= 0.95;
  return std::max(root, least);
}

class StepChoice {
 public:
  StepChoice(const DrivenProblem& problem, double tolerance_rad)
      : problem_(problem),
        tolerance_(tolerance_rad),
        splitting_(problem.axes, problem.forcing),
        composition_(splitting_.dependsOnMomentum() ? kahanLi8() : nystrom6()),
        forward_(planTo(problem.to_s)),
        backward_(planTo(problem.from_s)),
        rounding_rad_(kCommonRounding * std::max(forward_.turned_rad, backward_.turned_rad)) {}

  ChosenRun run() const;

 private:
  StepPlan planTo(double end_s) const;
  DrivenTrajectory trajectory(const StepPlan& plan, double scale, bool finer) const;
  ChosenRun attempt(double scale) const;

  const DrivenProblem& problem_;
  double tolerance_;
  Splitting splitting_;
  const Composition& composition_;
  StepPlan forward_, backward_;
  double rounding_rad_;
};

StepPlan StepChoice::planTo(double end_s) const {
  const Forcing& f = problem_.forcing;
  const bool conservative = !splitting_.dependsOnMomentum() && f.dragRate_P.isZero(0) && f.torque_B.isZero(0) &&
                            f.torque_W.isZero(0) && f.torqueHistory_B.empty() && f.torqueHistory_W.empty() &&
                            f.forces.empty();
  return pilotPlan(splitting_, composition_, problem_.start, forcingPieces(f, problem_.axes, end_s), conservative,
                   problem_.allowedSteps);
}

DrivenTrajectory StepChoice::trajectory(const StepPlan& plan, double scale, bool finer) const {
  return DrivenTrajectory(splitting_, composition_, problem_.start, plan, scale, finer, problem_.allowedSteps);
}

ChosenRun StepChoice::attempt(double scale) const {
  ChosenRun run{&composition_, trajectory(forward_, scale, true), trajectory(backward_, scale, true)};
  run.error_rad = rounding_rad_ + std::max(largestAngle(run.forward, trajectory(forward_, scale, false)),
                                           largestAngle(run.backward, trajectory(backward_, scale, false)));
  return run;
}

// The steps are short enough if the difference of two runs is as small as their common rounding error. Shorter
// steps would hardly reduce the estimated error.
ChosenRun StepChoice::run() const {
  const double goal = std::max(tolerance_, 2 * rounding_rad_);
  const double shortest = rootBelow(kWorthless / kPilotError, composition_.order + 1, 0);
  double scale = 1;
  ChosenRun best = attempt(scale);
  double last = best.error_rad;
  bool shorterIsWorthless = false;
  while (best.error_rad > goal && !shorterIsWorthless) {
    scale = std::max(shortest, scale * rootBelow(0.3 * goal / last, composition_.order, kShrinkMost));
    ChosenRun next = attempt(scale);
    shorterIsWorthless = scale <= shortest || (last < kAsymptotic_rad && next.error_rad > 0.5 * last);
    last = next.error_rad;
    if (last < best.error_rad) best = std::move(next);
  }
  best.limitedByRounding = best.error_rad > tolerance_;
  return best;
}

}  // namespace

ChosenRun chosenRun(const DrivenProblem& problem, double tolerance_rad) {
  return StepChoice(problem, tolerance_rad).run();
}

}  // namespace poinsot::physics
