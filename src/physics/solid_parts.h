// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "physics/mass_properties.h"

namespace poinsot::physics {

// Functions that divide a composite solid into simple pieces. Masses are in any common unit, because only their
// ratios matter. Internal to this library; other libraries call partsOf().

std::vector<SolidPart> piecesOf(const Capsule& solid);
std::vector<SolidPart> piecesOf(const LPlate& solid);
std::vector<SolidPart> piecesOf(const THandle& solid);
std::vector<SolidPart> piecesOf(const Racket& solid);
std::vector<SolidPart> piecesOf(const WingNut& solid);

}  // namespace poinsot::physics
