// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/solid.h"
#include "stage/body/sketch.h"

namespace poinsot::stage {

/// Draws a solid, with lines that make its rotation visible. Solids without thickness, such as a disc, are drawn
/// with a small thickness. Hollow solids are drawn with an opening.
void addSolid(const Sketch& sketch, const physics::Solid& solid);

}  // namespace poinsot::stage
