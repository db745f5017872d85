// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include "physics/unaligned_types.h"
#include "reference/grade.h"

namespace poinsot::reference {

/// Which axes of a log are turned against the scene's.
enum class TurnedAxes { kBoth, kBody, kSpace, kBodyOfAttitude, kSpaceOfAttitude, kOmega };

/// Names the turn that makes a log fit, whose axes it is of, and which axis is which.
/// @param toScene  takes components along the log's axes to those along the scene's.
FitCause turnCause(TurnedAxes axes, const physics::Quaternion& toScene);

/// Angle of a rotation, rad, 0 to pi.
double angleOf(const physics::Quaternion& turn);

}  // namespace poinsot::reference
