// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/keys/keys.h"

/// Scenes in which a key may be given.
namespace poinsot::scene {

/// The key's path with an index for []: "body.part[0].mass".
std::string pathIn(const Key& key);

/// A scene that lacks nothing but the key, or is one with any value for it.
std::string sceneFor(const Key& key);

}  // namespace poinsot::scene
