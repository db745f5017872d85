// SPDX-License-Identifier: Apache-2.0
#include "request/sweep_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"
#include "core/expect.h"
#include "core/text.h"
#include "request/memory.h"
#include "scene/motion/make_motion.h"
#include "stage/picture_motion.h"

namespace poinsot::request {
namespace {

using scene::Limit;

constexpr std::size_t kMostAxes = 2;  // the rows and the columns of the grid

/// Rejects a sweep of a key that applies to the complete film, such as its duration. All cells are in one film.
void expectOneFilm(const scene::SweepAxis& axis) {
  if (axis.key == "time.duration" || axis.key.starts_with("output."))
    throw core::usageError(fmt::format(
        "a sweep cannot vary {}: all cells are in one film, so they must agree in length, rate, size and paper",
        axis.key));
}

void expectGrid(const SceneRequest& request, const SweepGrid& grid) {
  const std::size_t ranges = grid.axes.size();
  if (request.sweep->map) {
    if (ranges > 0)
      throw core::usageError(fmt::format("--map shows one body; leave out the range of {}", grid.axes[0].key));
    return;
  }
  if (ranges == 0)
    throw core::usageError(
        "a sweep has one range or two: -D KEY=FROM..TO:COUNT, such as -D 'time.start=0..4 s:9'; or --times; --map "
        "has none");
  if (ranges > kMostAxes) throw core::usageError(fmt::format("a sweep has one range or two, got {}", ranges));
  if (grid.cells > scene::kMostCells)
    throw core::usageError(fmt::format("{} x {} are {} cells: a sweep has at most {}", grid.axes[0].values.size(),
                                       grid.axes.back().values.size(), grid.cells, scene::kMostCells));
  for (const scene::SweepAxis& axis : grid.axes) expectOneFilm(axis);
  for (const scene::SweepAxis& axis : grid.axes)
    if (axis.variesInstant() && axis.isWords)
      throw core::usageError(fmt::format("-D {}: a range has times, such as 0|0.9|1.8", axis.key));
}

/// Checks that the instants of a sheet are times of its film.
void expectInstants(const std::vector<scene::Scene>& cells) {
  for (const scene::Scene& cell : cells)
    if (const double still_s = cell.time.still_s.value_or(0); still_s > cell.time.duration_s)
      throw core::usageError(
          fmt::format("a cell at {} s: the film lasts from 0 to {} s; choose times of the film, or a longer film "
                      "with -D time.duration",
                      still_s, cell.time.duration_s));
}

/// Checks that all cells of one instant have the same time of the motion, because they share a label.
void expectSharedTimes(const std::vector<scene::Scene>& cells, const SweepGrid& grid, std::size_t axis) {
  std::map<std::size_t, double> times_s;  // by the index of the value
  for (int i = 0; i < grid.cells; ++i) {
    const scene::Scene& cell = cells[static_cast<std::size_t>(i)];
    const double t_s = stage::filmClock(cell).motionTime_s(cell.time.stillTime_s());
    if (times_s.try_emplace(grid.valueOf(axis, i), t_s).first->second != t_s)
      throw core::usageError(
          fmt::format("-D {}: changes the time of the motion, so that the cells of one instant show different "
                      "times; leave out "
                      "this range or the times",
                      grid.axes[1 - axis].key));
  }
}

void shareSpeed(std::vector<scene::Scene>& cells) {
  double least = INFINITY;
  for (const scene::Scene& cell : cells)
    if (!cell.time.speed) least = std::min(least, scene::chosenSpeed(cell));
  for (scene::Scene& cell : cells)
    if (!cell.time.speed) cell.time.speed = least;
}

}  // namespace

void expectOnce(const std::vector<std::string>& overrides, const std::string& key) {
  const auto isOfKey = [&](const std::string& word) {
    const auto from = std::min(word.find_first_not_of(' '), word.size());
    return word.compare(from, key.size(), key) == 0 &&
           word.find_first_not_of(' ', from + key.size()) == word.find('=');
  };
  if (std::ranges::count_if(overrides, isOfKey) > 1)
    throw core::usageError(fmt::format("-D {}: given more than once", key));
}

void expectFilm(const SceneRequest& request) {
  if (request.sweep && SweepGrid(request).variesInstant())
    throw core::usageError(
        fmt::format("-D {}: a sheet of several instants is one picture, not a film; use -o NAME.png, NAME.pdf, "
                    "NAME.svg or NAME.tex",
                    scene::kInstantKey));
}

bool hasRanges(const std::vector<std::string>& overrides) {
  return std::ranges::any_of(overrides, scene::hasRange);
}

void askForSweep(SceneRequest& request) {
  if (hasRanges(request.overrides)) request.sweep.emplace();
}

SweepGrid::SweepGrid(const SceneRequest& request) {
  POINSOT_EXPECT(request.sweep.has_value());
  for (std::size_t i = 0; i < request.overrides.size(); ++i) {
    auto axis = scene::sweepAxis(request.overrides[i]);
    if (!axis) continue;
    expectOnce(request.overrides, axis->key);
    cells *= static_cast<int>(axis->values.size());
    axes.push_back(std::move(*axis));
    overrides_.push_back(i);
    if (axes.size() > kMostAxes) break;  // keeps `cells` small; expectGrid() then throws
  }
  expectGrid(request, *this);
}

bool SweepGrid::variesInstant() const { return std::ranges::any_of(axes, &scene::SweepAxis::variesInstant); }

std::size_t SweepGrid::valueOf(std::size_t axis, int cell) const {
  const auto inRow = static_cast<int>(axes.at(0).values.size());
  return static_cast<std::size_t>(axis == 0 ? cell % inRow : cell / inRow);
}

SceneRequest cellRequest(const SceneRequest& request, const SweepGrid& grid, int cell) {
  SceneRequest one = request;
  one.sweep.reset();
  for (std::size_t axis = 0; axis < grid.axes.size(); ++axis)
    one.overrides.at(grid.overrides_[axis]) = grid.axes[axis].override(grid.valueOf(axis, cell));
  scene::Limits& limits = one.allowance.limits;
  for (const Limit limit : {Limit::kFilesBytes, Limit::kTriangles, Limit::kCharacters, Limit::kSteps})
    limits.set(limit, std::max<std::int64_t>(limits[limit] / grid.cells, 1));
  return one;
}

std::vector<scene::Scene> loadCells(const SceneRequest& request, const SweepGrid& grid,
                                    const scene::Scene& first) {
  expectWithinMemory(grid.cells * meshMemory_bytes(first), fmt::format("the meshes of {} cells", grid.cells),
                     request.allowance.limits);
  std::vector<scene::Scene> cells{first};
  for (int i = 1; i < grid.cells; ++i) cells.push_back(loadRequested(cellRequest(request, grid, i)));
  if (cells[0].time.loop)
    throw core::usageError(
        "a sweep cannot repeat: leave out --loop, which would change the motion of each cell in its own way");
  shareSpeed(cells);
  if (grid.variesInstant()) expectInstants(cells);
  for (std::size_t axis = 0; axis < grid.axes.size(); ++axis)
    if (grid.axes[axis].variesInstant()) expectSharedTimes(cells, grid, axis);
  return cells;
}

}  // namespace poinsot::request
