// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/color.h"
#include "scene/scene.h"

namespace poinsot::stage {

/// Colours by meaning: everything of L one hue, everything of omega another, everything of the body a third.
/// Okabe-Ito hues, which stay apart for colour-blind eyes; tints and shades follow the theme.
struct Palette {
  draw::Color paper, ink, quietInk;
  draw::Color L, plane, planeLine;
  draw::Color omega, trail, futureTrail, ellipsoid, graticule;
  draw::Color body, bodyEdge, axis;
  draw::Color rod;      ///< what holds a body together or up and has no mass
  double sheetOpacity;  ///< factor: in linear light a tint shows far more on dark paper than on white
};

Palette palette(scene::Theme theme);

}  // namespace poinsot::stage
