// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/color.h"
#include "image/image.h"
#include "text/coverage.h"

namespace poinsot::render {

/// Lays `color` over the picture where `map` covers it, in linear light. A fourth channel is straight alpha. What
/// of the map lies outside the picture is cut.
template <typename Sample>
void blendCoverage(const text::CoverageMap& map, const draw::Color& color, float opacity,
                   image::BasicImage<Sample>& picture);

/// Takes the picture away where `map` covers it, down to its paper. @pre four channels
template <typename Sample>
void eraseCoverage(const text::CoverageMap& map, float opacity, image::BasicImage<Sample>& picture);

}  // namespace poinsot::render
