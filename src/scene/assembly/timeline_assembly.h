// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/keys/draft.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// What the timeline shows is asked for with that: adds it to the scene's [show], unless that says otherwise.
/// Before the views are made, which start from it.
void askForShown(Draft& draft, const Findings& findings);

/// The entries, by time, and the captions that they give.
Timeline assembleTimeline(const Draft& draft, double duration_s, Findings& findings);

}  // namespace poinsot::scene
