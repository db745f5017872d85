// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "draw/picture.h"
#include "stage/palette.h"
#include "stage/plot/plot_axis.h"
#include "stage/type/pixel_box.h"

/// Static parts of a plot: axes, ticks, their labels, the title.
namespace poinsot::stage {

/// Room between a panel's edges and its contents, in em of the plot's text.
inline constexpr double kPlotEdge = 0.9;

struct PlotPen {
  Palette colors;
  double em_px = 24;
  double line_px = 2;
  scene::DecimalSign decimalSign = scene::DecimalSign::kPoint;
  double title = 1.1;  ///< size of the title, em
};

enum class Align { kLeft, kCentre, kRight };

/// Adds one line of text. Returns its width in px.
/// @param x  left end, middle or right end of the line, depending on `align`, px
double addLine(draw::Picture& picture, const std::string& tex, double x, double baseline, Align align,
               double em_px, const draw::Color& color);

double widthOf(const std::string& tex, double em_px);

struct PlotFrame {
  std::string title;
  PlotAxis x, y;
  bool equalScales = false;  ///< a unit of x is as long as a unit of y
};

/// Returns the area for curves inside a panel.
/// @param rightRoom_px  room at the right for values beside the curves; at least half the width of an x label is
/// kept
PixelBox curveArea(const PixelBox& panel, const PlotFrame& frame, double rightRoom_px, const PlotPen& pen);

/// Returns the frame with fewer ticks if the labels of its ticks would overlap.
PlotFrame fitted(const PlotFrame& frame, const PixelBox& area, const PlotPen& pen);

/// Draws the axes with their ticks and labels, and the title.
/// @pre `frame` is fitted to `area`.
void addFrame(draw::Picture& picture, const PixelBox& panel, const PixelBox& area, const PlotFrame& frame,
              const PlotPen& pen);

/// Return the left end and the baseline of the y axis's label, px. The label is above the numbers of the axis.
double labelLeft(const PixelBox& area, const PlotFrame& frame, const PlotPen& pen);
double labelRow(const PixelBox& area, const PlotPen& pen);

}  // namespace poinsot::stage
