// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/precession_cones.h"
#include "stage/picture_motion.h"

namespace poinsot::stage {

/// Returns the steady precession of the picture's motion.
/// @param key  scene key that the message names
/// @throws core::Error(kScene) unless the motion is that of a free symmetric top.
physics::PrecessionCones precessionOf(const PictureMotion& motion, const char* key);

/// Returns the principal axis that theta is measured from, on the side of the spin: the symmetry axis of a
/// symmetric body, otherwise the axis with the largest component of omega at the start.
Eigen::Vector3d mainAxis_P(const PictureMotion& motion);

}  // namespace poinsot::stage
