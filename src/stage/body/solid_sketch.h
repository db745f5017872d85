// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/solid.h"
#include "stage/body/sketch.h"

namespace poinsot::stage {

/// Draws a solid with lines that show its spin. Solids without thickness get a little, and hollow solids an
/// opening.
void addSolid(const Sketch& sketch, const physics::Solid& solid);

}  // namespace poinsot::stage
