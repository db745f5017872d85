// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/flip.h"
#include "image/image.h"

namespace poinsot::compare {

/// Returns a map as a picture in the colours of "magma", from black for 0 over red to pale yellow for 1. The
/// colour index is round(255 error).
image::Image magmaPicture(const FlipMap& map);

}  // namespace poinsot::compare
