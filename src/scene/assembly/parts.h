// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "scene/assembly/panel_grid.h"
#include "scene/assembly/scene_folder.h"
#include "scene/keys/draft.h"
#include "scene/keys/findings.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Makes the body that the keys below [body] describe together; empty if `findings` has a problem with it.
std::optional<Body> assembleBody(const Draft& draft, Findings& findings, const SceneFolder& folder);

/// Returns whether the body is given by its moments or its tensor, without a mass.
bool massIsUnknown(const Findings& findings);

/// Message for a key that needs a mass, if the body is given by its moments or its tensor alone.
inline constexpr const char* kNeedsMass = "needs a body with a mass; give body.mass beside the moments of inertia";

/// Assembles the forcing of the body: gravity, torques, drag, dissipation. Reports problems to `findings`.
/// @param body  null if the body is invalid
physics::Forcing assembleForcing(const Draft& draft, const Body* body, Findings& findings,
                                 const SceneFolder& folder);

/// Makes the flight of a thrown body; empty if the file has no [motion.flight].
std::optional<Flight> assembleFlight(const Draft& draft, Findings& findings);

/// Body that does not turn and that nothing sets going: the key that causes this, and its value.
struct Rest {
  std::string path, value;
};

/// Makes the start that the keys of [motion] describe together. Reports problems to `findings`.
/// @param body  null if the body is invalid
/// @param motion  receives the start; its forcing is already set
std::optional<Rest> assembleStart(const Draft& draft, const Body* body, Findings& findings, Motion& motion);

void assembleNamed(const Draft& draft, Findings& findings, Scene& scene);

/// Makes the panels of [[plot]] and places them after the views in `grid`. Reports problems to `findings`.
void assemblePlots(const Draft& draft, Findings& findings, PanelGrid& grid, Scene& scene);

void assembleNotes(const Draft& draft, Findings& findings, Scene& scene);

/// Hides Poinsot's construction for a thrown body, except parts that the scene has keys for. Call before
/// askForShown().
void leaveOutOfFlight(const Findings& findings, Show& show);

void assembleDrawnShape(const Draft& draft, Findings& findings, const SceneFolder& folder, Show& show);

/// Hides in `show` what this motion does not have, and rejects such things if the user asks for them.
/// @param prefix  text before "show" in the paths of the keys ("", "view[1].")
void assembleVisible(const Scene& scene, const std::optional<Rest>& rest, const std::string& prefix,
                     Findings& findings, Show& show);

/// Multiplies the given line width by the theme's factor.
void finishStyle(Style& style);

/// Makes the things visible that the timeline shows, unless the scene's [show] decides otherwise. Call before the
/// views are made, which start from [show].
void askForShown(Draft& draft, const Findings& findings);

Timeline assembleTimeline(const Draft& draft, double duration_s, Findings& findings);

/// Makes the views of the picture: those of [[view]], of camera.frames, or else one. Reports problems to
/// `findings`.
/// @pre body, motion and show of the scene are set
void assembleViews(const Draft& draft, const std::optional<Rest>& rest, Findings& findings, PanelGrid& grid,
                   Scene& scene);

}  // namespace poinsot::scene
