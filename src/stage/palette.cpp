// SPDX-License-Identifier: Apache-2.0
#include "stage/palette.h"

#include <algorithm>
#include <cmath>

namespace poinsot::stage {
namespace {

using scene::ColorMeaning;

using Srgb = std::uint32_t;

/// Base colours of a theme. All other colours are mixed from them.
struct Theme {
  Srgb paper, ink, L, omega, ellipsoid, omegaParts, separatrix, body, axis, torque, vector, support;
  double sheetOpacity = 1;
};

// Colours by Okabe & Ito: blue 0072B2, orange E69F00, vermilion D55E00, bluish green 009E73. Vermilion and bluish
// green are darker here, because labels on white need a contrast of 4.5.
constexpr Theme kLight{.paper = 0xFFFFFF,
                       .ink = 0x2B2F36,
                       .L = 0x0072B2,
                       .omega = 0xC75000,
                       .ellipsoid = 0xE69F00,
                       .omegaParts = 0x6B4400,
                       .separatrix = 0x8F1F66,
                       .body = 0x2FB58C,
                       .axis = 0x00805D,
                       .torque = 0x4B2A8C,
                       .vector = 0x6B7280,
                       .support = 0xA7AEB8};

constexpr Theme kDark{.paper = 0x14171C,
                      .ink = 0xE8EAED,
                      .L = 0x3FA9E8,
                      .omega = 0xFF7A2E,
                      .ellipsoid = 0xF7C948,
                      .omegaParts = 0xF3DDBB,
                      .separatrix = 0xF58FCB,
                      .body = 0x259B78,
                      .axis = 0x45CDA0,
                      .torque = 0xD3C0FF,
                      .vector = 0x8A92A0,
                      .support = 0x5A616D};

// Colours for a book that is printed in black and one second ink. All colours of omega are tints of the second
// ink. If it is printed in black only, its greys still differ in lightness.
constexpr Theme kPrint{.paper = 0xFFFFFF,
                       .ink = 0x000000,
                       .L = 0x1E1E1E,
                       .omega = 0xBF3A20,
                       .ellipsoid = 0xFF9F80,
                       .omegaParts = 0x7A2E1C,
                       .separatrix = 0x4F1408,
                       .body = 0xB4B4B4,
                       .axis = 0x4D4D4D,
                       .torque = 0x363636,
                       .vector = 0x747474,
                       .support = 0xD0D0D0,
                       .sheetOpacity = 1.4};

const Theme& themeOf(scene::Theme theme) {
  switch (theme) {
    case scene::Theme::kDark:
      return kDark;
    case scene::Theme::kPrint:
      return kPrint;
    case scene::Theme::kLight:
      break;
  }
  return kLight;
}

/// Mixes two colours by their sRGB values, because equal steps of sRGB values look equal.
/// @param share  fraction of `color` in the result
Srgb blend(Srgb color, Srgb over, double share) {
  Srgb result = 0;
  for (const int shift : {16, 8, 0}) {
    const auto channel = [shift](Srgb c) { return static_cast<double>(c >> shift & 0xff); };
    result |= static_cast<Srgb>(std::lround(share * channel(color) + (1 - share) * channel(over))) << shift;
  }
  return result;
}

bool isDark(Srgb paper) {
  const draw::Color linear = draw::fromSrgb(paper);
  return 0.2126f * linear.r + 0.7152f * linear.g + 0.0722f * linear.b < 0.18f;  // darker than middle grey
}

}  // namespace

Palette palette(const scene::Style& style) {
  const Theme& theme = themeOf(style.theme);
  const auto given = [&](ColorMeaning meaning, Srgb otherwise) {
    return style.colors[static_cast<std::size_t>(meaning)].value_or(otherwise);
  };
  const Srgb paper = given(ColorMeaning::kPaper, theme.paper), ink = given(ColorMeaning::kInk, theme.ink);
  const auto tint = [&](Srgb color, double share) { return blend(color, paper, share); };
  const Srgb L = given(ColorMeaning::kL, theme.L), plane = given(ColorMeaning::kPlane, tint(L, 0.7));
  const Srgb omega = given(ColorMeaning::kOmega, theme.omega);
  const Srgb polhode = given(ColorMeaning::kPolhode, omega), herpolhode = given(ColorMeaning::kHerpolhode, omega);
  const Srgb ellipsoid = given(ColorMeaning::kEllipsoid, theme.ellipsoid);
  const Srgb body = given(ColorMeaning::kBody, theme.body), axis = given(ColorMeaning::kAxis, theme.axis);
  using draw::fromSrgb;
  return {.paper = fromSrgb(paper),
          .ink = fromSrgb(ink),
          .quietInk = fromSrgb(given(ColorMeaning::kQuietInk, tint(ink, 0.76))),
          .L = fromSrgb(L),
          .plane = fromSrgb(plane),
          .planeLine = fromSrgb(blend(plane, L, 0.6)),
          .omega = fromSrgb(omega),
          .polhode = fromSrgb(polhode),
          .futurePolhode = fromSrgb(tint(polhode, 0.45)),
          .herpolhode = fromSrgb(herpolhode),
          .futureHerpolhode = fromSrgb(tint(herpolhode, 0.45)),
          .ellipsoid = fromSrgb(ellipsoid),
          .graticule = fromSrgb(given(ColorMeaning::kGraticule, blend(ellipsoid, omega, 0.5))),
          .omegaParts = fromSrgb(given(ColorMeaning::kOmegaParts, theme.omegaParts)),
          .separatrix = fromSrgb(given(ColorMeaning::kSeparatrix, theme.separatrix)),
          .body = fromSrgb(body),
          .bodyEdge = fromSrgb(blend(body, 0x000000, 0.45)),
          .mark = fromSrgb(given(ColorMeaning::kMark, blend(body, 0x000000, 0.3))),
          .lightMark = fromSrgb(blend(body, 0xFFFFFF, 0.25)),
          .axis = fromSrgb(axis),
          .spaceCone = fromSrgb(given(ColorMeaning::kSpaceCone, L)),
          .bodyCone = fromSrgb(given(ColorMeaning::kBodyCone, axis)),
          .torque = fromSrgb(given(ColorMeaning::kTorque, theme.torque)),
          .vector = fromSrgb(given(ColorMeaning::kVector, theme.vector)),
          .rod = fromSrgb(given(ColorMeaning::kSupport, theme.support)),
          .sheetOpacity = isDark(paper) ? 0.24 : theme.sheetOpacity};
}

Palette palette(scene::Theme theme) {
  scene::Style style;
  style.theme = theme;
  return palette(style);
}

double contrastRatio(const draw::Color& a, const draw::Color& b) {
  constexpr double kGlare = 0.05;
  const auto light = [](const draw::Color& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b + kGlare; };
  return std::max(light(a), light(b)) / std::min(light(a), light(b));
}

}  // namespace poinsot::stage
