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

/// A requested scene with the contents of all its files, so that drawing reads no files.
struct RequestedScene {
  SceneRequest request = {};
  scene::Scene scene = {};               ///< for a sweep, the scene of its first cell
  std::vector<scene::Scene> cells = {};  ///< scenes of a sweep's grid, row by row

  image::PixelSize size() const { return {scene.output.width, scene.output.height}; }
  void resize(image::PixelSize size);
};

/// Reads all files of the scene and validates it. For a sweep, also validates all cells and the labels.
/// @throws scene::SceneErrors with all problems; core::Error(kUsage) for a view that the scene lacks, or cells
/// that cannot form one film; core::Error(kPhysics) for the stability map of a body that has none.
RequestedScene requestedScene(SceneRequest request);

/// Makes the composer of a request: for the scene's film, the grid of its sweep, or the stability map of its body.
/// @param steps  ledger for the time spent on the motion; the composer may then be used by one thread only
/// @throws core::Error(kPhysics) if the scene shows something that its motion does not have.
std::unique_ptr<const stage::Composer> composerOf(const RequestedScene& requested,
                                                  core::StepLedger* steps = nullptr);

stage::Sizing sizingOf(const PictureOptions& form, glm::ivec2 size_px);

}  // namespace poinsot::request
