// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "request/scene_request.h"
#include "scene/sweep.h"

namespace poinsot::request {

/// Grid of the cells in a sweep, numbered row by row. The first range varies along a row, the second down a
/// column.
struct SweepGrid {
  /// @throws core::Error(kUsage) for a malformed range, a key given twice, no range or more than two ranges, more
  /// than scene::kMostCells cells, a range of a key that applies to the complete film, or a range for a stability
  /// map.
  /// @pre request.sweep
  explicit SweepGrid(const SceneRequest& request);

  std::vector<scene::SweepAxis> axes;  ///< one or two ranges; none for a stability map
  int cells = 1;

  std::size_t valueOf(std::size_t axis, int cell) const;
  /// Returns whether a range varies scene::kInstantKey. Each cell then shows its own film time, so that the grid
  /// can only be drawn as one picture.
  bool variesInstant() const;

 private:
  friend SceneRequest cellRequest(const SceneRequest& request, const SweepGrid& grid, int cell);
  std::vector<std::size_t> overrides_;  // index in request.overrides for each element of `axes`
};

/// Rejects a key that is given twice. Only the last override has an effect, so one of the values would be lost.
/// @throws core::Error(kUsage)
void expectOnce(const std::vector<std::string>& overrides, const std::string& key);

/// Rejects a sweep that varies the instant, because a film shows all instants. @throws core::Error(kUsage)
void expectFilm(const SceneRequest& request);

bool hasRanges(const std::vector<std::string>& overrides);

/// Makes the request a sweep if an override contains a range. Used by commands that draw both scenes and sweeps.
void askForSweep(SceneRequest& request);

/// Returns the request of one cell. Some limits apply to all cells together: file bytes, triangles, characters,
/// and steps of the motion. Each cell gets an equal part of these limits.
SceneRequest cellRequest(const SceneRequest& request, const SweepGrid& grid, int cell);

/// Loads the scenes of all cells, which form one film. Cells that give no speed get a common speed. It is the
/// slowest speed that would be chosen for any of these cells, so that no cell is too fast to watch. If the cells
/// are instants of a film, checks that they are within the film, and that a second range does not change their
/// times.
/// @param first  scene of the first cell, from loadRequested(request)
/// @throws scene::SceneErrors for problems of another cell; core::Error(kUsage) if the scene loops or for such
/// times; core::Error(kLimit) if the meshes would exceed Limit::kMemory, checked before they are loaded.
std::vector<scene::Scene> loadCells(const SceneRequest& request, const SweepGrid& grid, const scene::Scene& first);

}  // namespace poinsot::request
