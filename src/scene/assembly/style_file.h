// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>

#include "scene/assembly/scene_folder.h"
#include "scene/keys/leaves.h"

namespace poinsot::scene {

/// Adds the [style] of the file that style.file names. Values of the scene override those of the style file.
/// Checks everything in the file, with places of its own, and keeps its text in `sources`.
/// @throws SceneErrors with the one problem of a file that is not TOML.
void addStyleFile(const SceneFolder& folder, std::deque<Source>& sources, Leaves& leaves, Problems& problems);

}  // namespace poinsot::scene
