// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

/// What altText() consists of: whole sentences.
namespace poinsot::describe {

using Sentences = std::vector<std::string>;

/// The names of the principal axes, "e1" to "e3".
std::string axisName(int axis);

/// What turns: shape, size, mass, moments.
Sentences bodySentences(const scene::Scene& scene);
/// How it turns: what acts on it, its rates and periods, what stays.
Sentences motionSentences(const scene::Scene& scene);
/// What is drawn, in which colour, as seen by whom; how long the film is and how fast time runs in it.
Sentences pictureSentences(const scene::Scene& scene);

}  // namespace poinsot::describe
