// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "scene/assembly/motion_assembly.h"
#include "scene/assembly/scene_folder.h"
#include "scene/keys/draft.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// Of a thrown body Poinsot's construction is drawn where it is asked for; before anything is.
void leaveOutOfFlight(const Findings& findings, Show& show);

/// What is drawn in place of the body, into show.body; what is wrong goes to `findings`.
void assembleDrawnShape(const Draft& draft, Findings& findings, const SceneFolder& folder, Show& show);

/// Leaves out of `show` what this motion does not have, and refuses what the user asks for of that. `prefix`: what
/// stands before "show" in the paths of its keys ("", "view[1].").
void assembleVisible(const Scene& scene, const std::optional<Rest>& rest, const std::string& prefix,
                     Findings& findings, Show& show);

}  // namespace poinsot::scene
