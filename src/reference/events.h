// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "output/file_kind.h"
#include "reference/trajectory.h"
#include "scene/motion/scene_events.h"

namespace poinsot::reference {

/// Returns the events as text.
/// - CSV has the columns t, film_from, film_to and event, with one line for each event.
/// - JSON is an object with format, scene, units and events, each with the same four keys.
///
/// Numbers are the shortest decimals that read back as the same doubles. If the film does not show an event, its
/// film times are `nan` in CSV and `null` in JSON.
std::string eventsText(const std::vector<scene::SceneEvent>& events, TrajectoryFormat format,
                       const std::string& sceneName);

/// Returns the file kind by which earlier lists of events are recognised.
output::FileKind eventsKind(TrajectoryFormat format);

}  // namespace poinsot::reference
