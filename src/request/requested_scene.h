// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "image/image.h"
#include "request/scene_request.h"
#include "scene/scene.h"

namespace poinsot::request {

/// A scene as the user asked for it, with all that its files say: whoever draws it reads nothing any more.
struct RequestedScene {
  SceneRequest request = {};
  scene::Scene scene = {};               ///< of a sweep that of its first cell
  std::vector<scene::Scene> cells = {};  ///< of a sweep's grid, row by row

  image::PixelSize size() const { return {scene.output.width, scene.output.height}; }
  void resize(image::PixelSize size);
};

/// Reads all files of the scene and checks it; of a sweep also its cells and its labels.
/// @throws scene::SceneErrors with all problems; core::Error(kUsage) for a view that the scene does not have and
/// for cells that are no one film; core::Error(kPhysics) for the map of a body that has none.
RequestedScene requestedScene(SceneRequest request);

}  // namespace poinsot::request
