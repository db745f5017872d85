// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/color.h"
#include "scene/scene.h"

namespace poinsot::stage {

/// Colours by meaning, each meaning one hue: what belongs to L, what to omega, what to the body. They stay apart
/// for colour-blind eyes (tests/stage/palette_test.cpp); tints and shades of one meaning follow it.
struct Palette {
  draw::Color paper, ink, quietInk;
  draw::Color L, plane, planeLine;
  draw::Color omega;
  draw::Color polhode, futurePolhode;        ///< of omega in the body; travelled, and still to come
  draw::Color herpolhode, futureHerpolhode;  ///< of omega in space
  draw::Color ellipsoid, graticule;
  draw::Color omegaParts;  ///< components of omega
  draw::Color separatrix;
  draw::Color body, bodyEdge, axis;
  draw::Color spaceCone, bodyCone;
  draw::Color torque, vector;
  draw::Color rod;      ///< space axes, and what holds a body together or up and has no mass
  double sheetOpacity;  ///< factor: in linear light a tint shows far more on dark paper than on white
};

/// The theme's colours, with those that the style gives itself and what follows them.
Palette palette(const scene::Style& style);
/// The theme's own.
Palette palette(scene::Theme theme);

/// How well one colour is read on another, from 1 to 21: the ratio of their luminances (WCAG 2).
double contrastRatio(const draw::Color& a, const draw::Color& b);

}  // namespace poinsot::stage
