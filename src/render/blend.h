// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/color.h"
#include "image/image.h"
#include "render/screen_outline.h"
#include "text/coverage.h"

namespace poinsot::render {

/// Blends `color` over the picture where `map` covers it, in linear light. A fourth channel is straight alpha. The
/// map is clipped to the picture. Returns the pixels that may have changed.
template <typename Sample>
PixelBounds blendCoverage(const text::CoverageMap& map, const draw::Color& color, float opacity,
                          image::BasicImage<Sample>& picture);

/// Reduces the alpha of the picture where `map` covers it. Returns the pixels that may have changed. @pre four
/// channels
template <typename Sample>
PixelBounds eraseCoverage(const text::CoverageMap& map, float opacity, image::BasicImage<Sample>& picture);

}  // namespace poinsot::render
