// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "physics/mass_properties.h"

namespace poinsot::physics {

// The pieces of the solids that have no short formula of their own: masses in any common unit, only their ratios
// count. Internal to this layer; partsOf() is for others.

std::vector<SolidPart> piecesOf(const Capsule& solid);
std::vector<SolidPart> piecesOf(const LPlate& solid);
std::vector<SolidPart> piecesOf(const THandle& solid);
std::vector<SolidPart> piecesOf(const Racket& solid);
std::vector<SolidPart> piecesOf(const WingNut& solid);

}  // namespace poinsot::physics
