// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.h"

namespace poinsot::stage {

/// Returns the text of a note that shows a matrix: name, equals sign, numbers in brackets, and their unit. All
/// tensors in the notes of a scene have the same unit and the same decimals. A number that is only rounding is 0.
/// @pre the note has a matrix that the body has
std::string matrixText(const scene::Note& note, const scene::Scene& scene);

}  // namespace poinsot::stage
