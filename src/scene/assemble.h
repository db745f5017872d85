// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/draft.h"
#include "scene/leaves.h"

namespace poinsot::scene {

/// Makes the scene from keys that passed their own checks: what several keys decide together, and what physics
/// refuses, is checked here, each at the value it is about. `given` are the keys the user gave, whether valid or
/// not, `start` is where to report what is missing altogether.
/// What it returns counts only while `problems` is empty.
Scene assemble(Draft draft, const Leaves& given, const Place& start, Problems& problems);

}  // namespace poinsot::scene
