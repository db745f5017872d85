// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/step_times.h"
#include "request/picture_form.h"
#include "request/scene_request.h"
#include "stage/composer.h"

namespace poinsot::request {

/// What draws a request: the scene's film, the grid of its sweep, or the stability map of its body.
/// @param scene  loadRequested(request)
/// @param steps  where the time of the motion is entered; then it is of one thread.
/// @throws core::Error(kPhysics) where the scene asks for something its motion does not have; as loadCells().
std::unique_ptr<const stage::Composer> composerOf(const SceneRequest& request, const scene::Scene& scene,
                                                  core::StepLedger* steps = nullptr);

/// How large type and lines are in pictures of that size.
stage::Sizing sizingOf(const PictureForm& form, glm::ivec2 size_px);

/// What can be refused of a sweep before its motions are made: a cell, a label, the map of a body that has none.
/// @pre request.sweep
/// @throws as composerOf(), but for the motions.
void checkSweep(const SceneRequest& request, const scene::Scene& scene);

}  // namespace poinsot::request
