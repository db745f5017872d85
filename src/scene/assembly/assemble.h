// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/assembly/scene_folder.h"
#include "scene/keys/draft.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// Makes the scene from keys that passed their own checks. Also checks what several keys decide together, the
/// contents of named files, and what physics rejects; reports each problem at its value. The result is valid only
/// if no problem was found.
Scene assemble(Draft draft, Findings& findings, const SceneFolder& folder);

/// Notes values that are rarely intended: a bare whole number as an angle (radians are usually fractions), a bare
/// length of metres in a body whose other lengths have units, a density higher than that of any matter.
void doubtValues(const Leaves& leaves, Findings& findings);

}  // namespace poinsot::scene
