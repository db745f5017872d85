// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.h"

namespace poinsot::describe {

/// Returns a paragraph in plain English (UTF-8, no TeX) for readers who do not see the picture. It describes the
/// body, the motion, what is drawn in which colour, the views and the film, with the numbers of sceneReport() to
/// three digits.
/// @throws core::Error(kPhysics) for a motion that has no solution
std::string altText(const scene::Scene& scene);

}  // namespace poinsot::describe
