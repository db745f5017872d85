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

/// Makes the body from the keys in [body]. Returns nullopt after reporting a problem to `findings`.
std::optional<Body> assembleBody(const Draft& draft, Findings& findings, const SceneFolder& folder);

/// Returns whether the body is given by its moments or its inertia tensor and has no mass.
bool massIsUnknown(const Findings& findings);

/// Text of the error for a key that needs the mass, if the body has only moments or an inertia tensor.
inline constexpr const char* kNeedsMass =
    "needs a body with a mass; give body.mass in addition to the moments of inertia";

/// Makes the forcing of the body from the keys in [motion]: gravity, torques, forces at points, drag, dissipation.
/// Reports problems to `findings`.
/// @param body  null if the body is invalid
/// @param motion  receives the forcing and the labels of the forces
void assembleForcing(const Draft& draft, const Body* body, Findings& findings, const SceneFolder& folder,
                     Motion& motion);

/// Makes the flight of a thrown body. Returns nullopt if the scene has no table [motion.flight].
std::optional<Flight> assembleFlight(const Draft& draft, Findings& findings);

/// Makes the motion of a cone that rolls on a table, with its start, if the scene has the table [motion.rolling].
/// Reports problems to `findings`.
/// @param body  null if the body is invalid
void assembleRolling(const Draft& draft, const Body* body, Findings& findings, Motion& motion);

/// Moves position and velocity of the flight from the point K that the scene gives to the centre of mass: R + c
/// and V + omega x c, where c points from K to the centre of mass (eq 4). Without a point, does nothing.
/// @pre body and start of the scene are set
void throwByPoint(const Draft& draft, Scene& scene);

/// Path and value of the key that sets the rotation to 0, for a body that stays at rest.
struct Rest {
  std::string path, value;
};

/// Makes the start of the motion from the keys in [motion]. Returns the key to blame if the body stays at rest.
/// Reports problems to `findings`.
/// @param body  null if the body is invalid
/// @param motion  receives the start; its forcing must be set before
std::optional<Rest> assembleStart(const Draft& draft, const Body* body, Findings& findings, Motion& motion);

/// Makes the vectors and angles that the scene adds. Reports problems to `findings`.
/// @pre the motion is set
void assembleNamed(const Draft& draft, const std::optional<Rest>& rest, Findings& findings, Scene& scene);

/// Makes one panel for each [[plot]] and places it in `grid` after the views. Reports problems to `findings`.
void assemblePlots(const Draft& draft, Findings& findings, PanelGrid& grid, Scene& scene);

void assembleNotes(const Draft& draft, Findings& findings, Scene& scene);

/// Hides the parts of Poinsot's construction if the body is thrown, except parts for which the scene gives keys.
/// Call this before askForShown().
void leaveOutOfFlight(const Findings& findings, Show& show);

/// Adds the marks of the scene to the body. @pre the drawn shape is set.
void assembleMarks(const Draft& draft, Findings& findings, const SceneFolder& folder, Scene& scene);

void assembleDrawnShape(const Draft& draft, Findings& findings, const SceneFolder& folder, Show& show);

/// Hides things in `show` that do not exist for this motion. Reports a problem if the user requests such a thing.
/// @param prefix  path of the table that contains "show": "" for the scene, "view[1]." for a view
void assembleVisible(const Scene& scene, const std::optional<Rest>& rest, const std::string& prefix,
                     Findings& findings, Show& show);

/// Multiplies the line width of the scene by the factor of the theme.
void finishStyle(Style& style);

/// Makes things visible that an entry of the timeline shows, unless the scene's [show] sets their visibility. Call
/// this before the views are made, because each view starts as a copy of [show].
void askForShown(Draft& draft, const Findings& findings);

/// Sets the timeline of the scene. Reports problems to `findings`.
/// @pre body, motion and time of the scene are set, unless `findings` has problems
void assembleTimeline(const Draft& draft, Findings& findings, Scene& scene);

/// Makes the views of the picture: one for each [[view]], else one for each of camera.frames, else a single view.
/// Reports problems to `findings`.
/// @pre body, motion and show of the scene are set
void assembleViews(const Draft& draft, const std::optional<Rest>& rest, Findings& findings, PanelGrid& grid,
                   Scene& scene);

}  // namespace poinsot::scene
