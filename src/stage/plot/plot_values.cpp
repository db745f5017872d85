// SPDX-License-Identifier: Apache-2.0
#include "stage/plot/plot_values.h"

#include <algorithm>
#include <numeric>

namespace poinsot::stage {
namespace {

// Lengths in em of the plot's text.
constexpr double kGap = 0.7;     // gap between curve and name
constexpr double kEquals = 0.3;  // gap between "=" and value
constexpr double kRow = 1.3;     // distance of baselines
constexpr double kMiddle = 0.3;  // height of a letter's middle above its baseline

/// Returns the name of a quantity, with an equals sign if its value follows.
std::string nameTex(const PlotValue& value, bool hasValue) { return "$" + value.tex + (hasValue ? "\\,=$" : "$"); }

double namesWidth(const std::vector<PlotValue>& values, bool haveValues, double em_px) {
  double widest = 0;
  for (const PlotValue& value : values) widest = std::max(widest, widthOf(nameTex(value, haveValues), em_px));
  return widest;
}

/// Returns the width of "= 1.23" after a gap; the gap alone without values.
double digitsWidth_em(const std::optional<ValueFormat>& format, double gap_em) {
  return format ? gap_em + kEquals + format->width_em : gap_em;
}

}  // namespace

ValueFormat valueFormat(const PlotAxis& axis, scene::DecimalSign sign) {
  ValueFormat format;
  format.decimals = decimalsThatResolve(axis.high - axis.low);
  for (const double end : {axis.low, axis.high})
    format.width_em = std::max(format.width_em, widthOf(numberTex(fixedDigits(end, format.decimals), sign), 1));
  return format;
}

double valuesWidth(const std::vector<PlotValue>& values, const std::optional<ValueFormat>& format,
                   const PlotPen& pen) {
  if (values.empty()) return 0;
  return namesWidth(values, format.has_value(), pen.em_px) + digitsWidth_em(format, kGap) * pen.em_px;
}

std::vector<double> spread(const std::vector<double>& wanted, double apart, double low, double high) {
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return wanted[i]; });
  std::vector<double> place = wanted;
  double least = low;
  for (const std::size_t i : order) {
    place[i] = std::max(place[i], least);
    least = place[i] + apart;
  }
  double most = high;
  for (auto i = order.rbegin(); i != order.rend(); ++i) {
    place[*i] = std::min(place[*i], most);
    most = place[*i] - apart;
  }
  return place;
}

void addValues(draw::Picture& picture, const PixelBox& panel, const PixelBox& area,
               const std::vector<PlotValue>& values, const std::optional<ValueFormat>& format,
               const PlotPen& pen) {
  if (values.empty()) return;
  const bool haveValues = format.has_value();
  const double em = pen.em_px, names = area.right + kGap * em;
  const double right = names + namesWidth(values, haveValues, em) + digitsWidth_em(format, 0) * em;
  std::vector<double> wanted;
  for (const PlotValue& value : values)
    wanted.push_back(area.y(std::clamp(value.endShare, 0.0, 1.0)) + kMiddle * em);
  // Values stay beside the y axis if there is room. Values below the axis would touch the last number of the x
  // axis.
  const double first = panel.top + em, rows = static_cast<double>(values.size() - 1) * kRow * em;
  const double last = std::min(std::max(area.bottom + kMiddle * em, first + rows), panel.bottom - 0.5 * em);
  const std::vector<double> baselines = spread(wanted, kRow * em, first, last);
  for (std::size_t i = 0; i < values.size(); ++i) {
    addLine(picture, nameTex(values[i], haveValues), names, baselines[i], Align::kLeft, em, values[i].color);
    if (!format) continue;
    const std::string digits = fixedDigits(values[i].value, format->decimals);
    addLine(picture, numberTex(digits, pen.decimalSign), right, baselines[i], Align::kRight, em, values[i].color);
  }
}

}  // namespace poinsot::stage
