// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/color.h"
#include "scene/scene.h"

namespace poinsot::stage {

/// Colours by meaning. Each meaning, such as L, omega or the body, has one hue. Tints and shades keep that hue.
/// The hues also differ for colour-blind viewers (tests/stage/palette_test.cpp).
struct Palette {
  draw::Color paper, ink, quietInk;
  draw::Color L, plane, planeLine;
  draw::Color omega;
  draw::Color polhode, futurePolhode;  ///< path of omega in the body: travelled part, future part
  draw::Color herpolhode, futureHerpolhode;
  draw::Color ellipsoid, graticule;
  draw::Color omegaParts;
  draw::Color separatrix;
  draw::Color body, bodyEdge, mark, lightMark, axis;
  draw::Color spaceCone, bodyCone;
  draw::Color torque, vector;
  draw::Color rod;  ///< colour of space axes, supports, and massless rods between masses
  /// Factor on the thickness of translucent sheets. Less than 1 on dark paper, where a tint is far more visible.
  double sheetOpacity;
};

/// Returns the colours of the style's theme. Colours that the style sets itself take precedence. The other
/// colours, such as tints, are mixed from these.
Palette palette(const scene::Style& style);
Palette palette(scene::Theme theme);

/// Returns the contrast ratio of two colours, 1 to 21 (WCAG 2).
double contrastRatio(const draw::Color& a, const draw::Color& b);

}  // namespace poinsot::stage
