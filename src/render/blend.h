// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/color.h"
#include "image/image.h"
#include "render/screen_outline.h"
#include "text/coverage.h"

namespace poinsot::render {

/// Blends `color` over the picture where `map` covers it, in linear light. The fourth channel, if present, is
/// straight alpha. Clips the map to the picture. Returns the rectangle of pixels that may have changed.
template <typename Sample>
PixelBounds blendCoverage(const text::CoverageMap& map, const draw::Color& color, float opacity,
                          image::BasicImage<Sample>& picture);

/// Reduces the alpha of the picture where `map` covers it. Returns the rectangle of pixels that may have changed.
/// @pre the picture has four channels.
template <typename Sample>
PixelBounds eraseCoverage(const text::CoverageMap& map, float opacity, image::BasicImage<Sample>& picture);

}  // namespace poinsot::render
