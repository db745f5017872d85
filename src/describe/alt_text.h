// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.h"

namespace poinsot::describe {

/// A paragraph in plain English, UTF-8 without TeX, for readers who do not see the picture: the body, how it
/// turns, what stands still, what is drawn in which colour, the views and the film, with the numbers of
/// sceneReport() to three digits.
/// @throws core::Error(kPhysics) for a motion that has no solution.
std::string altText(const scene::Scene& scene);

}  // namespace poinsot::describe
