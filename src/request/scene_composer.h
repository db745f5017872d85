// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/step_times.h"
#include "request/picture_form.h"
#include "request/requested_scene.h"
#include "stage/composer.h"

namespace poinsot::request {

/// What draws a request: the scene's film, the grid of its sweep, or the stability map of its body.
/// @param steps  where the time of the motion is entered; then it is of one thread.
/// @throws core::Error(kPhysics) where the scene asks for something its motion does not have.
std::unique_ptr<const stage::Composer> composerOf(const RequestedScene& requested,
                                                  core::StepLedger* steps = nullptr);

/// How large type and lines are in pictures of that size.
stage::Sizing sizingOf(const PictureForm& form, glm::ivec2 size_px);

}  // namespace poinsot::request
