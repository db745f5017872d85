// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "physics/step_plan.h"

namespace poinsot::physics {

/// Integrated motion from time 0 to one end of the span. States are stored as checkpoints, with a fixed number of
/// steps between them. To compute a state, at() copies the checkpoint before t_s and integrates from there.
/// Immutable, thread-safe.
class DrivenTrajectory {
 public:
  /// Integrates every stretch of the plan (step_plan.h) in steps of `scale` times the planned length.
  /// @param finer takes at least a third more steps, so that a finer and a coarser trajectory can be compared
  /// @throws core::Error(kLimit) for more than mostSteps(), (kPhysics) if the state is no longer finite.
  DrivenTrajectory(const Splitting& splitting, const Composition& composition, const DrivenState& start,
                   const StepPlan& plan, double scale, bool finer, double allowedSteps = kMostSteps);

  /// Returns the state at time t_s. @pre t_s is between 0 and end_s().
  DrivenState at(double t_s) const;

  double end_s() const { return runs_.empty() ? 0 : runs_.back().stretch.end_s; }
  std::size_t steps() const { return steps_; }
  double shortestStep_s() const;

 private:
  struct Run {
    Stretch stretch;
    double h_s = 0;
    std::size_t whole = 0;   // number of steps of h_s (signed); one more step ends at the stretch's end
    std::size_t stored = 0;  // index of the run's first checkpoint
  };

  std::vector<Run> plannedRuns(const StepPlan& plan, double scale, bool finer, double allowedSteps);
  DrivenState integrated(const Run& run, DrivenState state);
  void step(DrivenState& state, const Run& run, std::size_t index) const;
  void sideStep(DrivenState& state, const Run& run, std::size_t index, double t_s) const;
  const Run& runAt(double t_s) const;

  Splitting splitting_;
  const Composition* composition_;
  std::vector<Run> runs_;
  std::vector<DrivenState> checkpoints_;
  DrivenState start_;
  std::size_t steps_ = 0;
  std::size_t stride_ = 1;  // number of steps between checkpoints
};

}  // namespace poinsot::physics
