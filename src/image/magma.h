// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/flip.h"
#include "image/image.h"

namespace poinsot::image {

/// A map as a picture in the colours of "magma", from black for 0 over red to pale yellow for 1: index
/// round(255 error).
Image magmaPicture(const FlipMap& map);

}  // namespace poinsot::image
