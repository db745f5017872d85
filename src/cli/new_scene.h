// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "request/user_files.h"

namespace poinsot::cli {

/// Returns a scene template with comments, in the user's units and with the keys of the user's defaults.
/// @param name  name of the scene, from which the title is derived
std::string blankScene(const std::string& name, const request::UserDefaults& defaults);

/// Returns a gallery scene with the user's default keys added. Omits keys that the scene already has, and keys
/// that would make it invalid.
std::string galleryScene(std::string text, const request::UserDefaults& defaults);

/// Sets a key in the text of a scene. Replaces the line of the key, or a comment with the key. If there is
/// neither, adds the key as the first line of its table, and adds the table if it is missing.
std::string withKey(std::string_view text, const request::DefaultKey& key);

}  // namespace poinsot::cli
