// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/panel_grid.h"

#include <fmt/format.h>

#include <algorithm>

namespace poinsot::scene {
namespace {

constexpr int kMostCells = 8;  // largest number of columns and of rows; more panels would be too small to read

}  // namespace

GridPlace PanelGrid::nextTo(const std::optional<Eigen::Vector2i>& at) const {
  GridPlace place;
  if (at) return {.column = (*at)[0], .row = (*at)[1]};
  if (taken_.empty()) return place;
  const GridPlace& before = taken_.back().place;
  return {.column = before.column + before.columns, .row = before.row};
}

void PanelGrid::check(const std::string& path, const GridPlace& place) {
  if (place.column + place.columns > kMostCells || place.row + place.rows > kMostCells)
    return findings_.refuse(path + ".at",
                            fmt::format("the panel at [{}, {}] would extend beyond the grid, which has at most {} "
                                        "columns and rows; give at, or a smaller span",
                                        place.column, place.row, kMostCells));
  const auto other = std::ranges::find_if(taken_, [&](const Taken& t) { return overlap(place, t.place); });
  if (other != taken_.end())
    findings_.refuse(path + ".at", fmt::format("the panel at [{}, {}] would overlap {}; give another at",
                                               place.column, place.row, other->name));
}

GridPlace PanelGrid::take(const std::string& path, const std::optional<Eigen::Vector2i>& at,
                          const std::optional<Eigen::Vector2i>& span) {
  GridPlace place = nextTo(at);
  if (span) place.columns = (*span)[0], place.rows = (*span)[1];
  check(path, place);
  taken_.push_back({path, place});
  return place;
}

}  // namespace poinsot::scene
