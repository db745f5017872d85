// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include "physics/unaligned_types.h"
#include "reference/grade.h"

namespace poinsot::reference {

/// Axes of a log that are rotated relative to the scene's axes.
enum class TurnedAxes { kBoth, kBody, kSpace, kBodyOfAttitude, kSpaceOfAttitude, kOmega };

/// Describes a rotation of axes with which a log fits: the rotated axes, the rotation, and the scene's axes in
/// terms of the log's.
/// @param toScene  rotation from components along the log's axes to components along the scene's axes
FitCause turnCause(TurnedAxes axes, const physics::Quaternion& toScene);

/// Returns the angle of a rotation, in rad, 0 to pi.
double angleOf(const physics::Quaternion& turn);

}  // namespace poinsot::reference
