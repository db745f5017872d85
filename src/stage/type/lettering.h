// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>

#include "core/abi.h"
#include "scene/scene.h"

/// Sizes of text and lines. note_rows.h sets text at fixed positions, and label_layout.h sets labels that move
/// with an object.
namespace poinsot::stage {

/// Size of an ordinary label, as a fraction of Sizing::type_px.
inline constexpr double kLabelSize = 0.044;

struct Sizing {
  double type_px = 1;    ///< reference size of text; an ordinary label is kLabelSize times as large
  double line_px = 2;    ///< width of an ordinary line
  double least_px = 0;   ///< smallest size of text at fixed positions, unless the text must shrink to fit
  double floor_px = 0;   ///< size below which text must not shrink, even if it does not fit
  bool isPrint = false;  ///< whether the picture is a figure on paper
};

/// Returns sizes for a screen, proportional to referenceHeight(). Text is legible from a distance at which the
/// complete picture is in view.
Sizing screenSizing(glm::vec2 size_px);
/// Returns sizes for print, independent of the picture's size: labels of 8.5 pt and lines of 0.6 pt. A point is
/// 1/72 inch.
Sizing printSizing(double pixelsPerInch);
/// Returns a sizing with the sizes of text that a style asks for. For a lecture hall, no text on a screen is
/// smaller than kHallType times the picture's height.
Sizing styled(const Sizing& sizing, const scene::Style& style, glm::vec2 size_px);
inline constexpr double kHallType = 0.033;

/// Returns a sizing in which all text is `factor` times as large. Lines keep their width.
Sizing typeScaled(const Sizing& sizing, double factor);

/// Returns the height of the largest 16:9 picture that fits into this size, in pixels.
double referenceHeight(glm::vec2 size_px);

}  // namespace poinsot::stage
