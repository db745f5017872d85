// SPDX-License-Identifier: Apache-2.0
#include "stage/plot/plot_curve.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace poinsot::stage {
namespace {

bool finite(const PlotPoint& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

double distance(const PlotPoint& p, const PlotPoint& a, const PlotPoint& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double along = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

PlotPoint crossing(const PlotPoint& a, const PlotPoint& b, double y) {
  const double share = (y - a.y) / (b.y - a.y);
  return {std::lerp(a.filmTime_s, b.filmTime_s, share), std::lerp(a.x, b.x, share), y};
}

bool inBand(const PlotPoint& p) { return p.y >= 0 && p.y <= 1; }

std::vector<PlotPoint> crossings(const PlotPoint& a, const PlotPoint& b) {
  std::vector<PlotPoint> all;
  for (const double y : {0.0, 1.0})
    if ((a.y < y && b.y > y) || (a.y > y && b.y < y)) all.push_back(crossing(a, b, y));
  if (all.size() == 2 && a.y > b.y) std::swap(all[0], all[1]);
  return all;
}

void addColumn(std::vector<PlotPoint>& kept, std::span<const PlotPoint> column) {
  const auto [low, high] = std::ranges::minmax_element(column, {}, &PlotPoint::y);
  std::ptrdiff_t picks[] = {0, low - column.begin(), high - column.begin(), std::ssize(column) - 1};
  std::ranges::sort(picks);
  const auto end = std::unique(std::begin(picks), std::end(picks));
  for (auto pick = std::begin(picks); pick != end; ++pick) kept.push_back(column[static_cast<std::size_t>(*pick)]);
}

// Number of points in a run. Curves are simplified run by run, because a long curve that returns to its start
// again and again would take quadratic time.
constexpr std::size_t kRun = 512;

/// Adds the points of a run that remain after simplification. The first point of a run is the last point of the
/// previous run, so it is added only once.
void addRun(std::vector<PlotPoint>& kept, std::span<const PlotPoint> run, double tolerance) {
  std::vector<bool> keep(run.size(), false);
  keep.front() = kept.empty();
  keep.back() = keep.back() || run.size() > 1;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, run.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i)
      if (const double d = distance(run[i], run[first], run[last]); d > most) most = d, farthest = i;
    if (farthest == first) continue;
    keep[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  for (std::size_t i = 0; i < run.size(); ++i)
    if (keep[i]) kept.push_back(run[i]);
}

}  // namespace

PlotPath finiteStretches(std::span<const PlotPoint> points) {
  PlotPath path;
  bool open = false;
  for (const PlotPoint& p : points) {
    if (finite(p) && !open) path.emplace_back();
    if (finite(p)) path.back().push_back(p);
    open = finite(p);
  }
  return path;
}

std::vector<PlotPoint> perColumn(std::span<const PlotPoint> points, int columns) {
  std::vector<PlotPoint> kept;
  const auto columnOf = [&](const PlotPoint& p) { return std::floor(p.x * columns); };
  for (std::size_t begin = 0; begin < points.size();) {
    std::size_t end = begin + 1;
    while (end < points.size() && columnOf(points[end]) == columnOf(points[begin])) ++end;
    addColumn(kept, points.subspan(begin, end - begin));
    begin = end;
  }
  return kept;
}

std::vector<PlotPoint> simplified(std::span<const PlotPoint> points, double tolerance) {
  std::vector<PlotPoint> kept;
  for (std::size_t begin = 0; begin < points.size(); begin += kRun)
    addRun(kept, points.subspan(begin, std::min(kRun + 1, points.size() - begin)), tolerance);
  return kept;
}

PlotPath insideBand(std::span<const PlotPoint> points) {
  PlotPath path;
  bool open = false;
  const auto add = [&](const PlotPoint& p) {
    if (!open) path.emplace_back();
    path.back().push_back(p);
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0)
      for (const PlotPoint& p : crossings(points[i - 1], points[i])) {
        add(p);
        open = !open;
      }
    if (inBand(points[i])) add(points[i]);
    open = inBand(points[i]);
  }
  return path;
}

std::vector<PlotPoint> before(std::span<const PlotPoint> points, const PlotPoint& cursor) {
  std::vector<PlotPoint> part;
  for (const PlotPoint& p : points)
    if (p.filmTime_s < cursor.filmTime_s) part.push_back(p);
  const bool within = !points.empty() && cursor.filmTime_s <= points.back().filmTime_s;
  if (!part.empty() && within && finite(cursor)) part.push_back(cursor);
  return part;
}

std::vector<PlotPoint> after(std::span<const PlotPoint> points, const PlotPoint& cursor) {
  std::vector<PlotPoint> part;
  const bool within = !points.empty() && cursor.filmTime_s >= points.front().filmTime_s &&
                      cursor.filmTime_s < points.back().filmTime_s;
  if (within && finite(cursor)) part.push_back(cursor);
  for (const PlotPoint& p : points)
    if (p.filmTime_s > cursor.filmTime_s) part.push_back(p);
  return part;
}

}  // namespace poinsot::stage
