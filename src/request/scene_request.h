// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "scene/limits.h"
#include "scene/scene.h"

namespace poinsot::request {

/// Request to draw a sweep of the scene's values instead of its film.
struct SweepRequest {
  bool map = false;                      ///< the stability map of the body; else a grid of films
  int columns = 0;                       ///< grid columns for one swept key; 0: chosen to make the cells largest
  std::vector<std::string> labels = {};  ///< TeX names of the swept keys; replace the default names
};

struct SceneRequest {
  std::string fileName = {};  ///< name as typed, for messages
  std::string text = {};
  std::vector<std::string> overrides = {};    ///< "key.path=value", in the order given
  std::optional<image::PixelSize> size = {};  ///< overrides output.size; unlike that key, sides may be odd
  scene::Allowance allowance{};               ///< limits, and further folders from which the scene may read
  std::optional<SweepRequest> sweep{};        ///< ranges in the overrides define the cells (sweep_cells.h)
  std::optional<std::size_t> view{};          ///< index of the view to draw alone, without plots
};

/// Reads the text of a scene file into a request.
/// @throws core::Error(kScene) if the file is missing, unreadable or not regular; (kLimit) if it is too long.
SceneRequest readSceneRequest(const std::string& fileName, std::vector<std::string> overrides,
                              const scene::Allowance& allowance = {});

/// Parses and validates the scene; for a sweep, the scene of its first cell.
/// @throws scene::SceneErrors with all problems; core::Error(kUsage) if the scene lacks the requested view.
scene::Scene loadRequested(const SceneRequest& request);

}  // namespace poinsot::request
