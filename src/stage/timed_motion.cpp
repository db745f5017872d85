// SPDX-License-Identifier: Apache-2.0
#include "stage/timed_motion.h"

#include <utility>

namespace poinsot::stage {
namespace {

class TimedMotion : public physics::Motion {
 public:
  TimedMotion(std::shared_ptr<const physics::Motion> motion, core::StepLedger* steps)
      : motion_(std::move(motion)), steps_(steps) {}

  physics::RigidBodyState at(double t_s) const override {
    const core::StepScope timing(steps_, core::Step::kSimulate);
    return motion_->at(t_s);
  }
  const physics::PrincipalAxes& axes() const override { return motion_->axes(); }
  double dissipation() const override { return motion_->dissipation(); }
  const physics::DrivenMotion* driven() const override { return motion_->driven(); }

 private:
  std::shared_ptr<const physics::Motion> motion_;
  core::StepLedger* steps_;
};

}  // namespace

std::shared_ptr<const physics::Motion> timed(std::shared_ptr<const physics::Motion> motion,
                                             core::StepLedger* steps) {
  if (steps == nullptr) return motion;
  return std::make_shared<TimedMotion>(std::move(motion), steps);
}

}  // namespace poinsot::stage
