// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/draft.h"
#include "scene/findings.h"

namespace poinsot::scene {

/// [[vector]] and [[angle]].
void assembleNamed(const Draft& draft, Findings& findings, Scene& scene);

}  // namespace poinsot::scene
