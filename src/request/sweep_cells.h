// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "request/scene_request.h"
#include "scene/sweep.h"

namespace poinsot::request {

/// Grid of cells that a sweep requests, numbered row by row. The values of the first range run along the rows.
struct SweepGrid {
  /// @throws core::Error(kUsage) for a malformed range, a key given twice, none or more than two ranges, more than
  /// scene::kMostCells cells, a key that changes the film as a whole, or any range beside a map.
  /// @pre request.sweep
  explicit SweepGrid(const SceneRequest& request);

  std::vector<scene::SweepAxis> axes;  ///< one or two; none for a map
  int cells = 1;

  std::size_t valueOf(std::size_t axis, int cell) const;

 private:
  friend SceneRequest cellRequest(const SceneRequest& request, const SweepGrid& grid, int cell);
  std::vector<std::size_t> overrides_;  // index of each axis's override in the request
};

bool hasRanges(const std::vector<std::string>& overrides);

/// Turns the request into a sweep if an override contains a range, for commands that draw both scenes and sweeps.
void askForSweep(SceneRequest& request);

/// Returns the request of one cell. Limits on a whole scene (file bytes, triangles, characters, steps of the
/// motion) are divided by the number of cells, so that all cells together respect them.
SceneRequest cellRequest(const SceneRequest& request, const SweepGrid& grid, int cell);

/// Loads the scenes of all cells, which form one film. Cells without a speed all take the least speed that any of
/// them would choose, so that none is too fast to watch.
/// @param first  scene of the first cell, from loadRequested(request)
/// @throws scene::SceneErrors for problems of another cell; core::Error(kUsage) if the scene loops;
/// core::Error(kLimit) if the meshes would exceed Limit::kMemory, checked before they are loaded.
std::vector<scene::Scene> loadCells(const SceneRequest& request, const SweepGrid& grid, const scene::Scene& first);

}  // namespace poinsot::request
