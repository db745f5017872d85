// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "scene/assembly/scene_folder.h"
#include "scene/keys/draft.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// The body that the keys below [body] describe together; empty where `findings` says what is wrong with it.
std::optional<Body> assembleBody(const Draft& draft, Findings& findings, const SceneFolder& folder);

/// Whether the body is given by its moments or its tensor, without a mass.
bool massIsUnknown(const Findings& findings);

/// Message for a key that needs a mass, of a body given by its moments or its tensor alone.
inline constexpr const char* kNeedsMass = "needs a body with a mass; give body.mass beside the moments of inertia";

}  // namespace poinsot::scene
