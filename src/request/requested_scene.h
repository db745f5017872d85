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

/// Scene of a request, with the contents of all files that the scene names. Drawing the scene reads no files.
struct RequestedScene {
  SceneRequest request = {};
  scene::Scene scene = {};               ///< the scene; for a sweep, the scene of the first cell
  std::vector<scene::Scene> cells = {};  ///< scenes of a sweep, one for each cell of the grid, row by row

  image::PixelSize size() const { return {scene.output.width, scene.output.height}; }
  void resize(image::PixelSize size);
  /// Sets style.text_size, the factor on the size of all text.
  void setTextSize(double factor);
};

/// Reads all files of the scene and validates the scene. For a sweep, also validates the scenes of all cells and
/// the labels.
/// @throws scene::SceneErrors with all problems; core::Error(kUsage) if the scene lacks the requested view or the
/// cells cannot form one film; core::Error(kPhysics) if a stability map is requested and the body has none.
RequestedScene requestedScene(SceneRequest request);

/// Makes the composer that draws the pictures of a request: a film, a grid of films for a sweep, or a stability
/// map.
/// @param steps  receives the time spent on the motion; only one thread can then use the composer
/// @throws core::Error(kPhysics) if the scene shows something that does not exist for its motion.
std::unique_ptr<const stage::Composer> composerOf(const RequestedScene& requested,
                                                  core::StepLedger* steps = nullptr);

/// Returns the sizes of text and lines in the picture of a request.
stage::Sizing sizingOf(const PictureOptions& form, const scene::Style& style, glm::ivec2 size_px);

}  // namespace poinsot::request
