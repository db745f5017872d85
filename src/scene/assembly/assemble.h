// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/assembly/scene_folder.h"
#include "scene/keys/draft.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// Makes the scene from keys that passed their own checks. Checks what the checks of single keys cannot:
/// combinations of keys, the contents of named files, and whether the physics is possible. Reports each problem at
/// the value that causes it. The result is valid only if no problem was found.
Scene assemble(Draft draft, Findings& findings, const SceneFolder& folder);

/// Adds notes about valid values that are probably mistakes: an angle such as 45, which counts as radians; an
/// angular velocity such as 360, which counts as rad/s; a length in metres without a unit, if other lengths of the
/// body have units; a density that no material has.
void doubtValues(const Scene& scene, const Leaves& leaves, Findings& findings);

}  // namespace poinsot::scene
