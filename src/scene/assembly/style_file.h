// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>

#include "scene/assembly/scene_folder.h"
#include "scene/keys/leaves.h"

namespace poinsot::scene {

/// Where style.file names a style file, adds what its [style] gives to what the scene gives, which counts before
/// it. Everything in it is checked, with places of its own; its text is kept in `sources`.
/// @throws SceneErrors with the one problem of a file that is not TOML.
void addStyleFile(const SceneFolder& folder, std::deque<Source>& sources, Leaves& leaves, Problems& problems);

}  // namespace poinsot::scene
