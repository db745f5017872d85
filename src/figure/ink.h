// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "draw/color.h"

namespace poinsot::figure {

/// Colour as page formats have it: sRGB in [0, 1], straight alpha, blended in encoded values.
struct Ink {
  glm::dvec3 srgb{0};
  double alpha = 1;
};

/// Returns the ink that gives over the paper what the renderer's blending in linear light gives. Encoded values
/// blend darker or lighter than light itself: a fifth of black on white is 0.91 of the way to white, not 0.8. If
/// no ink of that alpha matches, the result has a larger alpha.
Ink inkOver(const draw::Color& paper, const draw::Color& color, float opacity);

std::string hexOf(const Ink& ink);

}  // namespace poinsot::figure
