// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/color.h"
#include "scene/scene.h"

namespace poinsot::stage {

/// Colours by meaning. Each meaning (L, omega, the body) has one hue, and tints and shades keep that hue. The hues
/// differ for colour-blind eyes too (tests/stage/palette_test.cpp).
struct Palette {
  draw::Color paper, ink, quietInk;
  draw::Color L, plane, planeLine;
  draw::Color omega;
  draw::Color polhode, futurePolhode;  ///< path of omega in the body: travelled, and still to come
  draw::Color herpolhode, futureHerpolhode;
  draw::Color ellipsoid, graticule;
  draw::Color omegaParts;
  draw::Color separatrix;
  draw::Color body, bodyEdge, axis;
  draw::Color spaceCone, bodyCone;
  draw::Color torque, vector;
  draw::Color rod;  ///< space axes, supports, and massless rods between masses
  /// Factor on the thickness of translucent sheets, because in linear light a tint shows far more on dark paper.
  double sheetOpacity;
};

/// Returns the theme's colours, overridden by those of the style, with the colours that follow from them.
Palette palette(const scene::Style& style);
Palette palette(scene::Theme theme);

/// Returns the contrast ratio of two colours, 1 to 21 (WCAG 2).
double contrastRatio(const draw::Color& a, const draw::Color& b);

}  // namespace poinsot::stage
