// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/assembly/panel_grid.h"
#include "scene/keys/draft.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// The panels of [[plot]], into scene.plots, placed after the views that are in `grid`. What is wrong goes to
/// `findings`.
void assemblePlots(const Draft& draft, Findings& findings, PanelGrid& grid, Scene& scene);

/// What [[readout]] and [[note]] say, into the scene.
void assembleNotes(const Draft& draft, Findings& findings, Scene& scene);

}  // namespace poinsot::scene
