// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "request/scene_request.h"
#include "scene/sweep.h"

/// The scenes that a sweep draws side by side.
namespace poinsot::request {

/// What a sweep asks for. Cells are numbered row by row; the first range runs along the rows.
struct SweepGrid {
  /// @throws core::Error(kUsage) for a range that cannot be understood, none or more than two of them, more cells
  /// than scene::kMostCells, or any for a map. @pre request.sweep
  explicit SweepGrid(const SceneRequest& request);

  std::vector<scene::SweepAxis> axes;  ///< one or two; of a map none
  int cells = 1;

  /// Which of an axis's values a cell has.
  std::size_t valueOf(std::size_t axis, int cell) const;

 private:
  friend SceneRequest cellRequest(const SceneRequest& request, const SweepGrid& grid, int cell);
  std::vector<std::size_t> overrides_;  // of the axes, in the request
};

/// Whether the words after -D have a range.
bool hasRanges(const std::vector<std::string>& overrides);

/// Where its words have ranges, a request becomes one for a grid: of commands that draw what they are told to.
void askForSweep(SceneRequest& request);

/// What is asked for in one cell. What bounds all of a scene (its meshes, its text, the steps of its motion)
/// bounds all cells together.
SceneRequest cellRequest(const SceneRequest& request, const SweepGrid& grid, int cell);

/// The scenes of all cells, which are one film: of one length, rate, size, paper and pace. Where no speed is
/// given, it is the least of those that the cells would choose, so that none is too fast to watch.
/// @param first  loadRequested(request)
/// @throws scene::SceneErrors of another cell; core::Error(kUsage) for cells that are no one film, (kLimit) for
/// more memory than may be taken, said before it is.
std::vector<scene::Scene> loadCells(const SceneRequest& request, const SweepGrid& grid, const scene::Scene& first);

}  // namespace poinsot::request
