// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/color.h"
#include "image/image.h"
#include "render/screen_outline.h"
#include "text/coverage.h"

namespace poinsot::render {

/// Lays `color` over the picture where `map` covers it, in linear light. A fourth channel is straight alpha. What
/// of the map lies outside the picture is cut. Returns where it may have done something.
template <typename Sample>
PixelBounds blendCoverage(const text::CoverageMap& map, const draw::Color& color, float opacity,
                          image::BasicImage<Sample>& picture);

/// Takes the picture away where `map` covers it, down to its paper. Returns where. @pre four channels
template <typename Sample>
PixelBounds eraseCoverage(const text::CoverageMap& map, float opacity, image::BasicImage<Sample>& picture);

}  // namespace poinsot::render
