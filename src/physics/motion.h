// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/principal_axes.h"
#include "physics/rigid_body_state.h"

namespace poinsot::physics {

/// The rotation of a rigid body about its centre of mass or a fixed point, known at any time. Immutable and
/// thread-safe: at(t) depends on t alone.
class Motion {
 public:
  virtual ~Motion() = default;

  /// State at motion time t_s (seconds). Of q and -q the one with w >= 0. @pre t_s is within the span of the
  /// motion.
  virtual RigidBodyState at(double t_s) const = 0;

  virtual const PrincipalAxes& axes() const = 0;

 protected:
  Motion() = default;
  Motion(const Motion&) = default;
  Motion(Motion&&) = default;
  Motion& operator=(const Motion&) = default;
  Motion& operator=(Motion&&) = default;
};

}  // namespace poinsot::physics
