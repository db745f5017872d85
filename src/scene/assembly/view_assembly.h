// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "scene/assembly/motion_assembly.h"
#include "scene/assembly/panel_grid.h"
#include "scene/keys/draft.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// The panels of the picture, into scene.views: those of [[view]], of camera.frames, else one; of a scene whose
/// body, motion and show are known. What is wrong goes to `findings`.
void assembleViews(const Draft& draft, const std::optional<Rest>& rest, Findings& findings, PanelGrid& grid,
                   Scene& scene);

}  // namespace poinsot::scene
