// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/parts.h"

namespace poinsot::scene {
namespace {

// Factor on the line width of the print theme. Printers reproduce thinner lines than projectors do.
constexpr double kPrintLineWidth = 0.65;
// Factors for a lecture hall, whose last row sees the picture small.
constexpr double kHallLineWidth = 1.6, kHallTextSize = 1.2;

double lineWidthOfLook(const Style& style) {
  return (style.preset == StylePreset::kHall ? kHallLineWidth : 1) *
         (style.theme == Theme::kPrint ? kPrintLineWidth : 1);
}

}  // namespace

double lineWidthKey(const Style& style) { return style.lineWidth / lineWidthOfLook(style); }

void finishStyle(Style& style) {
  if (style.preset == StylePreset::kHall) style.textSize *= kHallTextSize;
  style.lineWidth *= lineWidthOfLook(style);
}

}  // namespace poinsot::scene
