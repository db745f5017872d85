// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/precession_cones.h"
#include "stage/picture_motion.h"

namespace poinsot::stage {

/// Returns the steady precession of the picture's motion.
/// @param key  scene key to name in the error message
/// @throws core::Error(kScene) unless the motion is that of a free symmetric top.
physics::PrecessionCones precessionOf(const PictureMotion& motion, const char* key);

/// Returns the axis k of the body, from which theta is measured, on the side of the spin. For a symmetric body, k
/// is the symmetry axis. For a cone on a table, k points from its apex to its base. Otherwise k is the principal
/// axis with the largest component of omega at the start.
Eigen::Vector3d mainAxis_P(const PictureMotion& motion);

}  // namespace poinsot::stage
