// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/flip.h"
#include "image/image.h"

namespace poinsot::compare {

/// Returns a FLIP map as a picture in the "magma" colours: black for error 0, then red, pale yellow for error 1.
/// The index into the colour table is round(255 error).
image::Image magmaPicture(const FlipMap& map);

}  // namespace poinsot::compare
