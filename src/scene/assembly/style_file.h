// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>

#include "scene/assembly/scene_folder.h"
#include "scene/keys/leaves.h"

namespace poinsot::scene {

/// Adds the values of the style file, which the key style.file names, to those of the scene. A value in the scene
/// overrides the value in the style file. Problems are reported at their line in the style file, so the text of
/// the file is kept in `sources`.
/// @throws SceneErrors with one problem if the file is not TOML.
void addStyleFile(const SceneFolder& folder, std::deque<Source>& sources, Leaves& leaves, Problems& problems);

}  // namespace poinsot::scene
