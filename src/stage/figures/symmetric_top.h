// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/precession_cones.h"
#include "stage/picture_motion.h"

namespace poinsot::stage {

/// The steady precession of the picture's motion. `key` is named in the message.
/// @throws core::Error(kScene) unless it is the motion of a free symmetric top.
physics::PrecessionCones precessionOf(const PictureMotion& motion, const char* key);

/// The principal axis that theta is measured from: the symmetry axis of a symmetric body, else the axis that it
/// spins about most at the start. On the side of the spin.
Eigen::Vector3d mainAxis_P(const PictureMotion& motion);

}  // namespace poinsot::stage
