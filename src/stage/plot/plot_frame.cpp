// SPDX-License-Identifier: Apache-2.0
#include "stage/plot/plot_frame.h"

#include <algorithm>
#include <glm/common.hpp>

#include "text/math_setter.h"

namespace poinsot::stage {
namespace {

// Lengths in em of the plot's text, unless stated otherwise.
constexpr double kDigit = 0.67;
constexpr double kTick = 0.28, kTickGap = 0.35;  // length of a tick; gap between axis and number
constexpr double kLabelRise = 0.95, kLabelAscent = 0.8;
constexpr double kTitleRow = 1.6;
constexpr double kTickRow = 1.15, kLabelRow = 2.45, kBelowLabels = 0.3;  // distances of rows below the x axis
constexpr double kLabelsApart = 0.8;                                     // gap between numbers at the x axis
constexpr double kRowApart = 1.7;                                        // distance of baselines at the y axis
constexpr double kAxisLine = 0.6, kZeroLine = 0.45;  // line widths, as multiples of an ordinary line

constexpr double kLeastLabel = 0.1;  // smallest size of a label that has no room, em

std::string tickTex(const Ticks& ticks, std::int64_t i, const PlotPen& pen) {
  return numberTex(tickDigits(ticks, i), pen.decimalSign);
}

double widestLabel(const Ticks& ticks, const PlotPen& pen) {
  double widest = 0;
  for (auto i = ticks.first; i <= ticks.last; ++i)
    widest = std::max(widest, widthOf(tickTex(ticks, i, pen), pen.em_px));
  return widest;
}

void addStroke(draw::Picture& picture, glm::dvec2 from, glm::dvec2 to, double width_px, const draw::Color& color) {
  draw::Stroke stroke;
  stroke.points_px = {glm::vec2(from), glm::vec2(to)};
  stroke.width_px = static_cast<float>(width_px);
  stroke.color = color;
  picture.strokes.push_back(std::move(stroke));
}

/// Shrinks an area in one direction, so that both axes have the same scale. Spare width is left at both sides.
PixelBox withEqualScales(PixelBox area, const PlotFrame& frame) {
  const double x = frame.x.high - frame.x.low, y = frame.y.high - frame.y.low;
  const double scale = std::min(area.width() / x, area.height() / y);
  const double spare = area.width() - scale * x;
  area.left += 0.5 * spare;
  area.right -= 0.5 * spare;
  area.top = area.bottom - scale * y;
  return area;
}

void addTicksX(draw::Picture& picture, const PixelBox& panel, const PixelBox& area, const PlotAxis& axis,
               const PlotPen& pen) {
  const double em = pen.em_px, line = kAxisLine * pen.line_px;
  for (auto i = axis.ticks.first; i <= axis.ticks.last; ++i) {
    const double x = area.x(axis.shareOfWritten(axis.ticks.at(i)));
    addStroke(picture, {x, area.bottom}, {x, area.bottom - kTick * em}, line, pen.colors.quietInk);
    const std::string tex = tickTex(axis.ticks, i, pen);
    const double half = 0.5 * widthOf(tex, em);
    const double inside = std::clamp(x, panel.left + half, std::max(panel.right - half, panel.left + half));
    addLine(picture, tex, inside, area.bottom + kTickRow * em, Align::kCentre, em, pen.colors.quietInk);
  }
}

void addTicksY(draw::Picture& picture, const PixelBox& area, const PlotAxis& axis, const PlotPen& pen) {
  const double em = pen.em_px, line = kAxisLine * pen.line_px;
  for (auto i = axis.ticks.first; i <= axis.ticks.last; ++i) {
    const double y = area.y(axis.shareOfWritten(axis.ticks.at(i)));
    addStroke(picture, {area.left, y}, {area.left + kTick * em, y}, line, pen.colors.quietInk);
    addLine(picture, tickTex(axis.ticks, i, pen), area.left - kTickGap * em, y + 0.5 * kDigit * em, Align::kRight,
            em, pen.colors.quietInk);
  }
}

void addZeroLines(draw::Picture& picture, const PixelBox& area, const PlotFrame& frame, const PlotPen& pen) {
  const double width = kZeroLine * pen.line_px;
  const draw::Color color = glm::mix(pen.colors.paper, pen.colors.quietInk, 0.35f);
  if (frame.y.low < 0 && frame.y.high > 0) {
    const double y = area.y(frame.y.shareOfWritten(0));
    addStroke(picture, {area.left, y}, {area.right, y}, width, color);
  }
  if (frame.equalScales && frame.x.low < 0 && frame.x.high > 0) {
    const double x = area.x(frame.x.shareOfWritten(0));
    addStroke(picture, {x, area.bottom}, {x, area.top}, width, color);
  }
}

void addLabel(draw::Picture& picture, const std::string& tex, double x, double baseline, Align align, double room,
              double em_px, const draw::Color& color) {
  const double width = widthOf(tex, em_px);
  const double size = width > room ? std::max(room / width, kLeastLabel) : 1;
  addLine(picture, tex, x, baseline, align, size * em_px, color);
}

}  // namespace

double widthOf(const std::string& tex, double em_px) { return text::setTex(tex).width_em * em_px; }

double addLine(draw::Picture& picture, const std::string& tex, double x, double baseline, Align align,
               double em_px, const draw::Color& color) {
  const double width = widthOf(tex, em_px);
  const double left = align == Align::kLeft ? x : align == Align::kCentre ? x - 0.5 * width : x - width;
  draw::Text text;
  text.tex = tex;
  text.baseline_px = glm::vec2(glm::dvec2(left, baseline));
  text.size_px = static_cast<float>(em_px);
  text.color = color;
  picture.texts.push_back(std::move(text));
  return width;
}

double labelLeft(const PixelBox& area, const PlotFrame& frame, const PlotPen& pen) {
  return area.left - kTickGap * pen.em_px - widestLabel(frame.y.ticks, pen);
}

double labelRow(const PixelBox& area, const PlotPen& pen) { return area.top - kLabelRise * pen.em_px; }

PixelBox curveArea(const PixelBox& panel, const PlotFrame& frame, double rightRoom_px, const PlotPen& pen) {
  const double em = pen.em_px;
  PixelBox area = panel;
  area.left += kPlotEdge * em + widestLabel(frame.y.ticks, pen) + kTickGap * em;
  area.top += (kPlotEdge + kLabelAscent + kLabelRise + (frame.title.empty() ? 0 : kTitleRow)) * em;
  area.right -= std::max(rightRoom_px, 0.5 * widestLabel(frame.x.ticks, pen)) + kPlotEdge * em;
  area.bottom -= (kLabelRow + kBelowLabels + kPlotEdge) * em;
  return frame.equalScales ? withEqualScales(area, frame) : area;
}

PlotFrame fitted(const PlotFrame& frame, const PixelBox& area, const PlotPen& pen) {
  PlotFrame fit = frame;
  fit.y = withFewerTicks(frame.y, static_cast<int>(area.height() / (kRowApart * pen.em_px)) + 1);
  for (int most = frame.x.ticks.count(); most > 3; --most) {
    fit.x = withFewerTicks(frame.x, most);
    const double apart = fit.x.ticks.step() / (fit.x.high - fit.x.low) * area.width();
    if (apart >= widestLabel(fit.x.ticks, pen) + kLabelsApart * pen.em_px) break;
  }
  return fit;
}

void addFrame(draw::Picture& picture, const PixelBox& panel, const PixelBox& area, const PlotFrame& frame,
              const PlotPen& pen) {
  const double em = pen.em_px, line = kAxisLine * pen.line_px;
  addZeroLines(picture, area, frame, pen);
  addStroke(picture, {area.left, area.top}, {area.left, area.bottom}, line, pen.colors.quietInk);
  addStroke(picture, {area.left, area.bottom}, {area.right, area.bottom}, line, pen.colors.quietInk);
  addTicksX(picture, panel, area, frame.x, pen);
  addTicksY(picture, area, frame.y, pen);
  const double left = panel.left + kPlotEdge * em, room = panel.width() - 2 * kPlotEdge * em;
  addLabel(picture, frame.y.label, labelLeft(area, frame, pen), labelRow(area, pen), Align::kLeft,
           panel.right - labelLeft(area, frame, pen), em, pen.colors.ink);
  addLabel(picture, frame.x.label, area.right, area.bottom + kLabelRow * em, Align::kRight, area.right - left, em,
           pen.colors.ink);
  if (!frame.title.empty())
    addLabel(picture, "\\textbf{" + frame.title + "}", left,
             panel.top + (kPlotEdge + kLabelAscent * pen.title) * em, Align::kLeft, room, pen.title * em,
             pen.colors.ink);
}

}  // namespace poinsot::stage
