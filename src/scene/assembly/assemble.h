// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/assembly/scene_folder.h"
#include "scene/keys/draft.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// Makes the scene from keys that passed their own checks: what several keys decide together, what the files say
/// that it names, and what physics refuses, is checked here, each at the value it is about.
/// What it returns counts only while nothing was found.
Scene assemble(Draft draft, Findings& findings, const SceneFolder& folder);

/// Doubts what is hardly ever meant: a bare whole number as an angle (who means radians writes a fraction), a bare
/// length of metres in a body whose other lengths have units, a density that no matter has.
void doubtValues(const Leaves& leaves, Findings& findings);

}  // namespace poinsot::scene
