// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/solid.h"

namespace poinsot::physics {

/// Checks that a solid is possible.
/// @throws core::Error(kPhysics) naming a length that is not positive and finite, lengths that do not fit
/// together, or a kind of polyhedron that does not exist.
void requirePossible(const Solid& solid);

/// Throws if a value is not positive and finite.
/// @throws core::Error(kPhysics) "NAME must be positive and finite, got VALUE".
void requirePositive(double value, const char* name);

}  // namespace poinsot::physics
