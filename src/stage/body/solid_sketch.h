// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/solid.h"
#include "stage/body/sketch.h"

namespace poinsot::stage {

/// Draws a solid with lines on it that show its spin. What has no thickness is given a little; what is hollow has
/// an opening.
void addSolid(const Sketch& sketch, const physics::Solid& solid);

}  // namespace poinsot::stage
