// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/draw_list.h"
#include "draw/picture.h"
#include "scene/scene.h"
#include "stage/palette.h"
#include "stage/picture_layout.h"

/// Type that stands still in a picture: title, notes. (label_layout.h: type that follows its
/// thing.)
namespace poinsot::stage {

/// An ordinary label, of what type is sized by.
inline constexpr double kLabelSize = 0.044;

/// How large type and lines are, in pixels.
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

/// Title and subtitle at the top left, set smaller where they would not fit; at the bottom, what is not to scale.
/// Returns how far down the title reaches, in pixels; 0 without one.
double addTitle(draw::Picture& picture, const scene::Scene& scene, const Sizing& sizing, const Palette& colors);

/// A panel's title and subtitle, centred over it. Returns how far down they reach from the panel's top.
double addHeading(draw::Picture& picture, const Cell& cell, const scene::View& view, const Sizing& sizing,
                  const Palette& colors);

}  // namespace poinsot::stage
