// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "request/user_files.h"

namespace poinsot::cli {

/// Returns a commented template of a scene, in the user's units and with the keys of the user's defaults.
/// @param name  name of the scene, from which its title is made
std::string blankScene(const std::string& name, const request::UserDefaults& defaults);

/// Returns a gallery scene with the default keys that the scene lacks, except for keys that make it invalid.
std::string galleryScene(std::string text, const request::UserDefaults& defaults);

/// Sets a key in the text of a scene. The new line replaces a line that has the key, or a comment that offers the
/// key; otherwise it becomes the first of its table, which is added if it is missing.
std::string withKey(std::string_view text, const request::DefaultKey& key);

}  // namespace poinsot::cli
