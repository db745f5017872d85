// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scene/state_quantity.h"
#include "stage/palette.h"

namespace poinsot::stage {

draw::Color familyColor(const Palette& colors, scene::QuantityFamily family);

/// Returns a colour for each quantity of a plot: the colour of the quantity's family. If several quantities belong
/// to one family, they get tones of its colour, from dark to light.
std::vector<draw::Color> quantityColors(const Palette& colors, const std::vector<int>& quantities);

}  // namespace poinsot::stage
