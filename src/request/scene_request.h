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

/// Request to draw a sweep, which varies one or two keys of the scene, or a stability map.
struct SweepRequest {
  bool map = false;  ///< draws the stability map of the body; if false, a grid of films
  int columns = 0;   ///< columns of the grid for one varied key; 0 for the number with the largest cells
  std::vector<std::string> labels = {};  ///< names of the varied keys as TeX; replace the default names
};

struct SceneRequest {
  std::string fileName = {};  ///< name as the user typed it, for messages
  std::string text = {};
  std::vector<std::string> overrides = {};    ///< values such as "key.path=value", in the given order
  std::optional<image::PixelSize> size = {};  ///< replaces the key output.size; the sides may be odd
  scene::Allowance allowance{};         ///< limits, and folders outside the scene's folder that the scene may read
  std::optional<SweepRequest> sweep{};  ///< set for a sweep; `overrides` then contain ranges (sweep_cells.h)
  std::optional<std::size_t> view{};    ///< index of the only view to draw, without plots
};

/// Reads the text of a scene file and returns a request to draw the scene.
/// @throws core::Error(kScene) if the file is missing, unreadable or not regular; (kLimit) if it is too long.
SceneRequest readSceneRequest(const std::string& fileName, std::vector<std::string> overrides,
                              const scene::Allowance& allowance = {});

/// Validates the text of a request and returns the scene. For a sweep, returns the scene of the first cell.
/// @throws scene::SceneErrors with all problems; core::Error(kUsage) if the scene lacks the requested view.
scene::Scene loadRequested(const SceneRequest& request);

}  // namespace poinsot::request
