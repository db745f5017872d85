// SPDX-License-Identifier: Apache-2.0
#include "physics/driven_trajectory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/expect.h"
#include "core/interruption.h"

namespace poinsot::physics {
namespace {

constexpr std::size_t kMostCheckpoints = std::size_t{1} << 18;  // these states take 30 MB

void requireFiniteState(const DrivenState& state, double t) {
  const auto& q = state.q_WP;
  const double sum = q.w.hi + q.x.hi + q.y.hi + q.z.hi + norm({state.L_W[0].hi, state.L_W[1].hi, state.L_W[2].hi});
  if (std::isfinite(sum)) return;
  throw core::physicsError(
      fmt::format("the driven motion is beyond the range of numbers at t = {:.6g} s; shorten the run, "
                  "or weaken what drives the body",
                  t));
}

void requireFewEnough(double steps, double tolerated) {
  if (steps <= tolerated) return;
  throw core::limitError(
      fmt::format("the driven motion needs {:.3g} steps, more than the {:.0f} allowed in a run; shorten the run, "
                  "or set a larger tolerance",
                  steps, tolerated));
}

}  // namespace

std::vector<DrivenTrajectory::Run> DrivenTrajectory::plannedRuns(const StepPlan& plan, double scale, bool finer,
                                                                 double allowedSteps) {
  std::vector<Run> runs;
  double total = 0;
  for (const Stretch& stretch : plan.stretches) {
    const double coarse = stepsIn(stretch, scale, 1);
    const double n = finer ? coarse + std::ceil(coarse / 3) : coarse;
    total += n;
    requireFewEnough(total, mostSteps(*composition_, allowedSteps));
    runs.push_back({stretch, (stretch.end_s - stretch.begin_s) / n, static_cast<std::size_t>(n) - 1, 0});
  }
  steps_ = static_cast<std::size_t>(total);
  stride_ = 1 + steps_ / kMostCheckpoints;
  return runs;
}

DrivenTrajectory::DrivenTrajectory(const Splitting& splitting, const Composition& composition,
                                   const DrivenState& start, const StepPlan& plan, double scale, bool finer,
                                   double allowedSteps)
    : splitting_(splitting), composition_(&composition), start_(start) {
  runs_ = plannedRuns(plan, scale, finer, allowedSteps);
  DrivenState state = start;
  for (Run& run : runs_) {
    run.stored = checkpoints_.size();
    state = integrated(run, state);
  }
}

DrivenState DrivenTrajectory::integrated(const Run& run, DrivenState state) {
  for (std::size_t k = 0; k < run.whole; ++k) {
    core::checkInterruption();
    if (k % stride_ == 0) checkpoints_.push_back(state);
    step(state, run, k);
  }
  if (run.whole % stride_ == 0) checkpoints_.push_back(state);
  sideStep(state, run, run.whole, run.stretch.end_s);
  requireFiniteState(state, run.stretch.end_s);
  return state;
}

/// Advances the state by step number `index`, from index * h to (index + 1) * h after the start of the run.
void DrivenTrajectory::step(DrivenState& state, const Run& run, std::size_t index) const {
  if (run.stretch.atRest) return state.stop();
  const double since = run.stretch.begin_s - run.stretch.piece.begin_s + static_cast<double>(index) * run.h_s;
  splitting_.step(state, *composition_, run.stretch.piece, since, run.h_s);
}

/// Advances the state from the start of step number `index` to t_s. The length of this step is computed without
/// rounding.
void DrivenTrajectory::sideStep(DrivenState& state, const Run& run, std::size_t index, double t_s) const {
  if (run.stretch.atRest) return state.stop();
  const DoubleDouble gone = twoProduct(static_cast<double>(index), run.h_s);
  const double rest = toDouble(twoSum(t_s, -run.stretch.begin_s) - gone);
  const double since = run.stretch.begin_s - run.stretch.piece.begin_s + gone.hi;
  if (rest != 0) splitting_.step(state, *composition_, run.stretch.piece, since, rest);
}

const DrivenTrajectory::Run& DrivenTrajectory::runAt(double t_s) const {
  const auto before = [&](const Run& run) { return std::abs(run.stretch.end_s) < std::abs(t_s); };
  const auto found = std::partition_point(runs_.begin(), runs_.end(), before);
  POINSOT_EXPECT(found != runs_.end());
  return *found;
}

DrivenState DrivenTrajectory::at(double t_s) const {
  if (t_s == 0) return start_;
  const Run& run = runAt(t_s);
  const double passed = std::floor((t_s - run.stretch.begin_s) / run.h_s);
  const auto k = static_cast<std::size_t>(std::clamp(passed, 0.0, static_cast<double>(run.whole)));
  DrivenState state = checkpoints_[run.stored + k / stride_];
  for (std::size_t i = k - k % stride_; i < k; ++i) step(state, run, i);
  sideStep(state, run, k, t_s);
  return state;
}

double DrivenTrajectory::shortestStep_s() const {
  double shortest = std::abs(end_s());
  for (const Run& run : runs_) shortest = std::min(shortest, std::abs(run.h_s));
  return shortest;
}

}  // namespace poinsot::physics
