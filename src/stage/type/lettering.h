// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>

#include "core/abi.h"

/// How large type and lines are. (note_rows.h: type that stands still. label_layout.h: type that follows its
/// thing.)
namespace poinsot::stage {

/// An ordinary label, of what type is sized by.
inline constexpr double kLabelSize = 0.044;

/// In pixels.
struct Sizing {
  double type_px = 1;   ///< what type is sized by: labels are kLabelSize of it
  double line_px = 2;   ///< width of an ordinary line
  double least_px = 0;  ///< no line of type that stands still is set smaller, but to fit in its place
};

/// By the height of the largest 16:9 picture inside one of this size: to be seen from afar, all of it at once.
Sizing screenSizing(glm::vec2 size_px);
/// In points, whatever the picture's size: labels of 8.5 pt, lines of 0.6 pt. A point is 1/72 inch.
Sizing printSizing(double pixelsPerInch);
/// All type `factor` times as large, lines as they are.
Sizing typeScaled(const Sizing& sizing, double factor);

/// The height of the largest 16:9 picture inside one of this size, in pixels.
double referenceHeight(glm::vec2 size_px);

}  // namespace poinsot::stage
