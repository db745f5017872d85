// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/draft.h"
#include "scene/leaves.h"

namespace poinsot::scene {

/// Where to report what is missing: in its table where the file has that, else at the file's start.
struct Origins {
  Place file, body, motion;
};

/// Makes the scene from keys that passed their own checks: what several keys decide together, and what physics
/// refuses, is checked here, each at the value it is about. `given` are the keys the user gave, valid or not.
/// What it returns counts only while `problems` is empty.
Scene assemble(Draft draft, const Leaves& given, const Origins& origins, Problems& problems);

}  // namespace poinsot::scene
