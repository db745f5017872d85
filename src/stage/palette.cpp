// SPDX-License-Identifier: Apache-2.0
#include "stage/palette.h"

namespace poinsot::stage {
namespace {

using draw::fromSrgb;

// Okabe & Ito: blue 0072B2, vermilion D55E00, orange E69F00, bluish green 009E73.
Palette light() {
  return {.paper = fromSrgb(0xFFFFFF),
          .ink = fromSrgb(0x2B2F36),
          .quietInk = fromSrgb(0x565C66),
          .L = fromSrgb(0x0072B2),
          .plane = fromSrgb(0x4E9BCB),
          .planeLine = fromSrgb(0x2F86BE),
          .omega = fromSrgb(0xD55E00),
          .trail = fromSrgb(0xD55E00),
          .futureTrail = fromSrgb(0xF3BF93),
          .ellipsoid = fromSrgb(0xE69F00),
          .graticule = fromSrgb(0xC8780A),
          .body = fromSrgb(0x2FB58C),
          .bodyEdge = fromSrgb(0x00543D),
          .axis = fromSrgb(0x009E73),
          .rod = fromSrgb(0x9AA1AC),
          .sheetOpacity = 1};
}

Palette dark() {
  return {.paper = fromSrgb(0x14171C),
          .ink = fromSrgb(0xE8EAED),
          .quietInk = fromSrgb(0x9AA1AC),
          .L = fromSrgb(0x3FA9E8),
          .plane = fromSrgb(0x2F86BE),
          .planeLine = fromSrgb(0x4E9BCB),
          .omega = fromSrgb(0xFF8126),
          .trail = fromSrgb(0xFF8126),
          .futureTrail = fromSrgb(0x7A431B),
          .ellipsoid = fromSrgb(0xF2B632),
          .graticule = fromSrgb(0xF0A830),
          .body = fromSrgb(0x2FB58C),
          .bodyEdge = fromSrgb(0x00382A),
          .axis = fromSrgb(0x2FCB9B),
          .rod = fromSrgb(0x6B7280),
          .sheetOpacity = 0.3};
}

}  // namespace

Palette palette(scene::Theme theme) { return theme == scene::Theme::kDark ? dark() : light(); }

}  // namespace poinsot::stage
