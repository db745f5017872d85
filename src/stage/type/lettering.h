// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>

#include "core/abi.h"

/// Sizes of type and lines. note_rows.h sets type that stands still, label_layout.h type that moves with an
/// object.
namespace poinsot::stage {

/// Size of an ordinary label, as a share of Sizing::type_px.
inline constexpr double kLabelSize = 0.044;

struct Sizing {
  double type_px = 1;   ///< reference size of type; ordinary labels are kLabelSize of it
  double line_px = 2;   ///< width of an ordinary line
  double least_px = 0;  ///< smallest size of type that stands still, unless the type must shrink to fit
};

/// Returns sizes for a screen, proportional to referenceHeight(): legible from afar with the whole picture in
/// view.
Sizing screenSizing(glm::vec2 size_px);
/// Returns sizes in points, independent of the picture's size: labels of 8.5 pt, lines of 0.6 pt. A point is 1/72
/// inch.
Sizing printSizing(double pixelsPerInch);
/// Returns a sizing with all type `factor` times as large and unchanged lines.
Sizing typeScaled(const Sizing& sizing, double factor);

/// Returns the height of the largest 16:9 picture inside one of this size, in pixels.
double referenceHeight(glm::vec2 size_px);

}  // namespace poinsot::stage
