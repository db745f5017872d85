// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/keys/draft.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// [[vector]] and [[angle]].
void assembleNamed(const Draft& draft, Findings& findings, Scene& scene);

}  // namespace poinsot::scene
