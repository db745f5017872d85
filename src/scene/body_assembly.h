// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "scene/draft.h"
#include "scene/findings.h"
#include "scene/scene_folder.h"

namespace poinsot::scene {

/// The body that the keys below [body] describe together; empty where `findings` says what is wrong with it.
std::optional<Body> assembleBody(const Draft& draft, Findings& findings, const SceneFolder& folder);

/// Whether the body is given by its moments alone, or by its tensor: in no way that says how heavy it is.
bool massIsUnknown(const Findings& findings);

}  // namespace poinsot::scene
