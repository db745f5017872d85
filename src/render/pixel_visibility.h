// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "render/pixel_fragment.h"

namespace poinsot::render {

/// Which share of the pixel each fragment is seen in: exact areas where nothing is hidden, else by samples.
/// @return one number to a fragment; their sum is at most 1.
std::vector<double> visibleAreas(std::span<const PixelFragment> fragments);

}  // namespace poinsot::render
