// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "physics/step_plan.h"

namespace poinsot::physics {

/// The integrated motion from 0 to one end of the run: the state after every so many steps. Between, at() goes on
/// from the state before, by whole steps and one shorter, on a copy. Immutable, thread-safe.
class DrivenTrajectory {
 public:
  /// Every stretch of the plan in steps of `scale` times the plan's length: `finer` by a third or more than
  /// without, so that the two can be compared.
  /// @throws core::Error(kLimit) for more than mostSteps(), (kPhysics) where the state is no longer finite.
  DrivenTrajectory(const Splitting& splitting, const Composition& composition, const DrivenState& start,
                   const StepPlan& plan, double scale, bool finer, double allowedSteps = kMostSteps);

  /// @pre t_s is between 0 and the end.
  DrivenState at(double t_s) const;

  double end_s() const { return runs_.empty() ? 0 : runs_.back().stretch.end_s; }
  std::size_t steps() const { return steps_; }
  double shortestStep_s() const;

 private:
  struct Run {
    Stretch stretch;
    double h_s = 0;          // signed
    std::size_t whole = 0;   // steps of exactly h_s; one more, of h_s to rounding, ends at the stretch's end
    std::size_t stored = 0;  // where its checkpoints begin
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
  std::size_t stride_ = 1;  // steps from checkpoint to checkpoint
};

}  // namespace poinsot::physics
