// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/step_times.h"
#include "image/image.h"
#include "request/picture_options.h"
#include "request/scene_request.h"
#include "scene/scene.h"
#include "stage/composer.h"

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

/// What draws a request: the scene's film, the grid of its sweep, or the stability map of its body.
/// @param steps  where the time of the motion is entered; then it is of one thread.
/// @throws core::Error(kPhysics) where the scene asks for something its motion does not have.
std::unique_ptr<const stage::Composer> composerOf(const RequestedScene& requested,
                                                  core::StepLedger* steps = nullptr);

/// How large type and lines are in pictures of that size.
stage::Sizing sizingOf(const PictureOptions& form, glm::ivec2 size_px);

}  // namespace poinsot::request
