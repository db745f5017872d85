// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "physics/precession_cones.h"
#include "physics/rolling_cone.h"
#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Actor for the two parts of omega. For a free symmetric top, they are omega_p along L, and -Omega_p k along the
/// axis k (eq 32, 34). For a cone on a table, they are Omega_v along the vertical, and the spin along the cone's
/// axis. The parts are the sides of a parallelogram whose diagonal is omega.
class DecompositionFigure final : public Actor {
 public:
  /// @throws core::Error(kScene) unless the motion is that of a free symmetric top or of a rolling cone.
  explicit DecompositionFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  physics::AngularVelocityParts parts_V(const PictureState& state) const;

 private:
  std::optional<physics::RollingCone> rolling_;
  physics::PrecessionCones cones_;  // not set for a rolling cone
  double scale_;
};

}  // namespace poinsot::stage
