// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/assembly/scene_folder.h"
#include "scene/keys/draft.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// What acts on the body: gravity, torques, drag, dissipation; what is wrong goes to `findings`. `body` is null
/// where that is wrong itself.
physics::Forcing assembleForcing(const Draft& draft, const Body* body, Findings& findings,
                                 const SceneFolder& folder);

/// How a thrown body flies, where [motion.flight] stands in the file.
std::optional<Flight> assembleFlight(const Draft& draft, Findings& findings);

}  // namespace poinsot::scene
