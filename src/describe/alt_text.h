// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.h"

namespace poinsot::describe {

/// Returns a text for readers who do not see the picture: a paragraph in plain English or German (UTF-8,
/// no TeX), as output.language says. It
/// describes the body, the motion, the colours of the things that are drawn, the views and the film. The numbers
/// are those of sceneReport(), with three digits.
/// @throws core::Error(kPhysics) for a motion that has no solution
std::string altText(const scene::Scene& scene);

}  // namespace poinsot::describe
