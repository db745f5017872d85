// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/keys/keys.h"

/// Scenes in which a key may be given.
namespace poinsot::scene {

/// Returns the key's path with an index for [], such as "body.part[0].mass".
std::string pathIn(const Key& key);

/// Returns a scene that is complete except for the key, or complete with any value of the key.
std::string sceneFor(const Key& key);

}  // namespace poinsot::scene
