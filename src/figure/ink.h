// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "draw/color.h"

namespace poinsot::figure {

/// Colour for PDF and SVG: sRGB in [0, 1] with straight alpha. These formats blend encoded values.
struct Ink {
  glm::dvec3 srgb{0};
  double alpha = 1;
};

/// Returns the ink that has the same colour over the paper as the renderer's blending in linear light. The two
/// ways of blending differ: black of opacity 0.2 on white gives the encoded value 0.91 in linear light, but 0.8 if
/// encoded values are blended. If no ink of the given opacity matches, the result has a larger alpha.
Ink inkOver(const draw::Color& paper, const draw::Color& color, float opacity);

std::string hexOf(const Ink& ink);

}  // namespace poinsot::figure
