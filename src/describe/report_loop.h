// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.h"

namespace poinsot::describe {

/// Describes the changes that make a film repeat, such as "the film repeats after 14.3 s; omega at the start
/// changed by 0.53 deg (0.9 %), speed from 0.7 to 0.7004 (+0.06 %)".
std::string loopText(const scene::Scene& scene);

}  // namespace poinsot::describe
