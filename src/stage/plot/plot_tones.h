// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scene/state_quantity.h"
#include "stage/palette.h"

namespace poinsot::stage {

draw::Color familyColor(const Palette& colors, scene::QuantityFamily family);

/// Returns one colour for each of a plot's quantities: its family's colour, or tones of it from dark to light if
/// the plot has several quantities of the family.
std::vector<draw::Color> quantityColors(const Palette& colors, const std::vector<int>& quantities);

}  // namespace poinsot::stage
