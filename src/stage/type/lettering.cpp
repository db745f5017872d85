// SPDX-License-Identifier: Apache-2.0
#include "stage/type/lettering.h"

#include <algorithm>

namespace poinsot::stage {
namespace {

// Width of a line, as a fraction of the reference height.
constexpr double kLine = 2.0 / 1080;
// Sizes in print, in points. Labels are as large as captions in a book, and lines are thick enough to be
// photocopied.
constexpr double kPrintedLabel = 8.5, kPrintedLine = 0.6, kLeastPrinted = 6.5;

}  // namespace

double referenceHeight(glm::vec2 size_px) {
  return std::min(static_cast<double>(size_px.y), static_cast<double>(size_px.x) * 9 / 16);
}

Sizing screenSizing(glm::vec2 size_px) {
  const double H = referenceHeight(size_px);
  return {H, kLine * H, 0};
}

Sizing printSizing(double pixelsPerInch) {
  const double point_px = pixelsPerInch / 72;
  return {kPrintedLabel / kLabelSize * point_px, kPrintedLine * point_px, kLeastPrinted * point_px, 0, true};
}

Sizing typeScaled(const Sizing& sizing, double factor) {
  Sizing result = sizing;
  result.type_px *= factor;
  result.least_px = std::max(factor * sizing.least_px, sizing.floor_px);
  return result;
}

Sizing fixedSizing(double pixelsPerInch, double small_px) {
  Sizing sizing = printSizing(pixelsPerInch);
  sizing.type_px = small_px / kLabelSize;
  sizing.least_px = sizing.floor_px = sizing.fixed_px = small_px;
  return sizing;
}

Sizing inPart(const Sizing& sizing, double type, double line) {
  Sizing part = sizing;
  if (!(sizing.fixed_px > 0)) part.type_px *= type;
  part.line_px *= line;
  return part;
}

double smallSize_px(double share, const Sizing& sizing) {
  return sizing.fixed_px > 0 ? sizing.fixed_px : std::max(share * sizing.type_px, sizing.least_px);
}

double titleSize_px(double share, const Sizing& sizing) {
  return sizing.fixed_px > 0 ? kFixedTitle * sizing.fixed_px : smallSize_px(share, sizing);
}

double arrowNameOf(const Sizing& sizing) { return sizing.fixed_px > 0 ? kFixedArrowName : kArrowName; }

Sizing styled(const Sizing& sizing, const scene::Style& style, glm::vec2 size_px) {
  Sizing result = sizing;
  if (style.preset == scene::StylePreset::kHall && !sizing.isPrint)
    result.floor_px = kHallType * static_cast<double>(size_px.y);
  result.least_px = std::max(sizing.least_px, result.floor_px / style.textSize);
  return result;
}

}  // namespace poinsot::stage
