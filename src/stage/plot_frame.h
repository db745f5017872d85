// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "draw/picture.h"
#include "stage/palette.h"
#include "stage/plot_axis.h"

/// What of a plot stands still: axes, ticks, their labels, the title.
namespace poinsot::stage {

/// What a plot is drawn with.
struct PlotPen {
  Palette colors;
  double em_px = 24;   ///< size of its type
  double line_px = 2;  ///< an ordinary line
  scene::DecimalSign decimalSign = scene::DecimalSign::kPoint;
};

/// Where type stands on its line.
enum class Align { kLeft, kCentre, kRight };

/// Adds one line of type at `x`, `baseline`, px. Returns its width in px.
double addLine(draw::Picture& picture, const std::string& tex, double x, double baseline, Align align,
               double em_px, const draw::Color& color);

/// In px at that size of type.
double widthOf(const std::string& tex, double em_px);

/// A rectangle of the picture, px from its top left corner, y down.
struct PlotBox {
  double left = 0, top = 0, right = 0, bottom = 0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  double x(double share) const { return left + share * width(); }
  double y(double share) const { return bottom - share * height(); }
};

struct PlotFrame {
  std::string title;
  PlotAxis x, y;
  bool equalScales = false;  ///< a unit of x is as long as one of y
};

/// Room that a plot needs at its right for what it writes beside the curves, px; at least the half of a label at
/// the x axis.
PlotBox curveArea(const PlotBox& panel, const PlotFrame& frame, double rightRoom_px, const PlotPen& pen);

/// So few ticks that their labels stay apart.
PlotFrame fitted(const PlotFrame& frame, const PlotBox& area, const PlotPen& pen);

/// @pre `frame` is fitted to `area`.
void addFrame(draw::Picture& picture, const PlotBox& panel, const PlotBox& area, const PlotFrame& frame,
              const PlotPen& pen);

/// Where the y axis's label begins, over the axis's own labels, and its baseline; px.
double labelLeft(const PlotBox& area, const PlotFrame& frame, const PlotPen& pen);
double labelRow(const PlotBox& area, const PlotPen& pen);

}  // namespace poinsot::stage
