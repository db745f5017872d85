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

/// The body that the keys below [body] describe together; empty where `findings` says what is wrong with it.
std::optional<Body> assembleBody(const Draft& draft, Findings& findings, const SceneFolder& folder);

/// Whether the body is given by its moments or its tensor, without a mass.
bool massIsUnknown(const Findings& findings);

/// Message for a key that needs a mass, of a body given by its moments or its tensor alone.
inline constexpr const char* kNeedsMass = "needs a body with a mass; give body.mass beside the moments of inertia";

/// What acts on the body: gravity, torques, drag, dissipation; what is wrong goes to `findings`. `body` is null
/// where that is wrong itself.
physics::Forcing assembleForcing(const Draft& draft, const Body* body, Findings& findings,
                                 const SceneFolder& folder);

/// How a thrown body flies, where [motion.flight] stands in the file.
std::optional<Flight> assembleFlight(const Draft& draft, Findings& findings);

/// A body that does not turn, and that nothing sets going: the key that says so, and its value.
struct Rest {
  std::string path, value;
};

/// The start that the keys of [motion] describe together, into `motion`, whose forcing is known; what is wrong
/// goes to `findings`. `body` is null where that is wrong itself.
std::optional<Rest> assembleStart(const Draft& draft, const Body* body, Findings& findings, Motion& motion);

/// [[vector]] and [[angle]].
void assembleNamed(const Draft& draft, Findings& findings, Scene& scene);

/// The panels of [[plot]], into scene.plots, placed after the views that are in `grid`. What is wrong goes to
/// `findings`.
void assemblePlots(const Draft& draft, Findings& findings, PanelGrid& grid, Scene& scene);

/// What [[readout]] and [[note]] say, into the scene.
void assembleNotes(const Draft& draft, Findings& findings, Scene& scene);

/// Of a thrown body Poinsot's construction is drawn where it is asked for; before anything is.
void leaveOutOfFlight(const Findings& findings, Show& show);

/// What is drawn in place of the body, into show.body; what is wrong goes to `findings`.
void assembleDrawnShape(const Draft& draft, Findings& findings, const SceneFolder& folder, Show& show);

/// Leaves out of `show` what this motion does not have, and refuses what the user asks for of that. `prefix`: what
/// stands before "show" in the paths of its keys ("", "view[1].").
void assembleVisible(const Scene& scene, const std::optional<Rest>& rest, const std::string& prefix,
                     Findings& findings, Show& show);

/// From what was given to what is drawn: line widths become the theme's, times the factor given.
void finishStyle(Style& style);

/// What the timeline shows is asked for with that: adds it to the scene's [show], unless that says otherwise.
/// Before the views are made, which start from it.
void askForShown(Draft& draft, const Findings& findings);

/// The entries, by time, and the captions that they give.
Timeline assembleTimeline(const Draft& draft, double duration_s, Findings& findings);

/// The panels of the picture, into scene.views: those of [[view]], of camera.frames, else one; of a scene whose
/// body, motion and show are known. What is wrong goes to `findings`.
void assembleViews(const Draft& draft, const std::optional<Rest>& rest, Findings& findings, PanelGrid& grid,
                   Scene& scene);

}  // namespace poinsot::scene
