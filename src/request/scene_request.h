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

/// What is drawn of a scene in place of its film: its values swept.
struct SweepRequest {
  bool map = false;                      ///< the stability map of its body; else a grid of films
  int columns = 0;                       ///< of the grid of one range; 0: as the picture has room
  std::vector<std::string> labels = {};  ///< names of the swept keys in TeX, in place of their own
};

/// A scene as the user asked for it.
struct SceneRequest {
  std::string fileName = {};  ///< as given, for messages
  std::string text = {};
  std::vector<std::string> overrides = {};    ///< "key.path=value", in the order given
  std::optional<image::PixelSize> size = {};  ///< in place of the scene's; may be odd, which the key may not
  scene::Allowance allowance{};               ///< how much, and files of which folders besides its own
  std::optional<SweepRequest> sweep{};        ///< ranges among the overrides stand for cells (sweep_cells.h)
  std::optional<std::size_t> view{};  ///< that view as the whole picture, without the others and without plots
};

/// Reads the file.
/// @throws core::Error(kScene) if it is missing, unreadable or no regular file; (kLimit) if it is too long for a
/// scene.
SceneRequest readSceneRequest(const std::string& fileName, std::vector<std::string> overrides,
                              const scene::Allowance& allowance = {});

/// The validated scene; of a sweep that of its first cell.
/// @throws scene::SceneErrors with all problems; core::Error(kUsage) if the scene does not have that view.
scene::Scene loadRequested(const SceneRequest& request);

}  // namespace poinsot::request
