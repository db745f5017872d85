// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "draw/picture.h"
#include "stage/palette.h"
#include "stage/plot/plot_axis.h"
#include "stage/type/pixel_box.h"

/// What of a plot stands still: axes, ticks, their labels, the title.
namespace poinsot::stage {

/// Between a panel's edges and what is in it, em of the plot's type.
inline constexpr double kPlotEdge = 0.9;

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

struct PlotFrame {
  std::string title;
  PlotAxis x, y;
  bool equalScales = false;  ///< a unit of x is as long as one of y
};

/// Room that a plot needs at its right for what it writes beside the curves, px; at least the half of a label at
/// the x axis.
PixelBox curveArea(const PixelBox& panel, const PlotFrame& frame, double rightRoom_px, const PlotPen& pen);

/// So few ticks that their labels stay apart.
PlotFrame fitted(const PlotFrame& frame, const PixelBox& area, const PlotPen& pen);

/// @pre `frame` is fitted to `area`.
void addFrame(draw::Picture& picture, const PixelBox& panel, const PixelBox& area, const PlotFrame& frame,
              const PlotPen& pen);

/// Where the y axis's label begins, over the axis's own labels, and its baseline; px.
double labelLeft(const PixelBox& area, const PlotFrame& frame, const PlotPen& pen);
double labelRow(const PixelBox& area, const PlotPen& pen);

}  // namespace poinsot::stage
