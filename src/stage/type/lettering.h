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

/// Size of the names of L, omega and the torque, as a multiple of an ordinary label.
inline constexpr double kArrowName = 1.15;

struct Sizing {
  double type_px = 1;    ///< reference size of text; an ordinary label is kLabelSize times as large
  double line_px = 2;    ///< width of an ordinary line
  double least_px = 0;   ///< smallest size of text at fixed positions, unless the text must shrink to fit
  double floor_px = 0;   ///< size below which text must not shrink, even if it does not fit
  bool isPrint = false;  ///< whether the picture is a figure on paper
  double fixed_px = 0;   ///< size of all small text in views and plots of any size; 0: sizes depend on the layout
};

/// Returns sizes for a screen, proportional to referenceHeight(). Text is legible from a distance at which the
/// complete picture is in view.
Sizing screenSizing(glm::vec2 size_px);
/// Returns sizes for print, independent of the picture's size: labels of 8.5 pt and lines of 0.6 pt. A point is
/// 1/72 inch.
Sizing printSizing(double pixelsPerInch);
/// Returns printSizing() with one size for all small text: axes, notes, read-outs, plots and labels of a sheet.
/// Titles are kFixedTitle times, and the names of L, omega and the torque kFixedArrowName times as large. This
/// text does not depend on the layout and does not shrink, except a line that is too long for its room.
Sizing fixedSizing(double pixelsPerInch, double small_px);
inline constexpr double kFixedTitle = 8.0 / 7, kFixedArrowName = 10.0 / 7;

/// Returns a sizing with the sizes of text that a style asks for. For a lecture hall, no text on a screen is
/// smaller than kHallType times the picture's height.
Sizing styled(const Sizing& sizing, const scene::Style& style, glm::vec2 size_px);
inline constexpr double kHallType = 0.033;

/// Returns a sizing in which all text is `factor` times as large. Lines keep their width.
Sizing typeScaled(const Sizing& sizing, double factor);

/// Returns the sizing in a part of a picture, where text is `type` times and lines are `line` times as large.
Sizing inPart(const Sizing& sizing, double type, double line);

/// Returns the size of a small text. @param share  its size as a fraction of Sizing::type_px
double smallSize_px(double share, const Sizing& sizing);
/// Returns the size of a title. @param share  its size as a fraction of Sizing::type_px
double titleSize_px(double share, const Sizing& sizing);
/// Returns the size of the names of L, omega and the torque, as a multiple of an ordinary label.
double arrowNameOf(const Sizing& sizing);

/// Returns the height of the largest 16:9 picture that fits into this size, in pixels.
double referenceHeight(glm::vec2 size_px);

}  // namespace poinsot::stage
