// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "draw/color.h"

namespace poinsot::figure {

/// A colour as page formats have it: sRGB in [0, 1], straight alpha, blended as encoded.
struct Ink {
  glm::dvec3 srgb{0};
  double alpha = 1;
};

/// The ink that looks over the paper as the renderer's blending in linear light does. Encoded values blend
/// darker or lighter than light itself: a fifth of black on white is 0.91 of the way to white, not 0.8. Where no
/// ink of that alpha would do, one of more alpha is taken.
Ink inkOver(const draw::Color& paper, const draw::Color& color, float opacity);

/// "#rrggbb".
std::string hexOf(const Ink& ink);

}  // namespace poinsot::figure
