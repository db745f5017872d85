// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scene/state_quantity.h"
#include "stage/palette.h"

namespace poinsot::stage {

/// The colour that a family's meaning has.
draw::Color familyColor(const Palette& colors, scene::QuantityFamily family);

/// One colour for each of a plot's quantities: its family's, and where it has several, tones of it from dark to
/// light.
std::vector<draw::Color> quantityColors(const Palette& colors, const std::vector<int>& quantities);

}  // namespace poinsot::stage
