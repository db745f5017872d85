// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "request/user_files.h"

namespace poinsot::cli {

/// A scene to begin with, with comments, in the user's units and with the keys that he always wants.
/// @param name  of the scene; a title is made of it.
std::string blankScene(const std::string& name, const request::UserDefaults& defaults);

/// A scene of the gallery with those of the user's keys that it does not have itself and that fit it.
std::string galleryScene(std::string text, const request::UserDefaults& defaults);

/// The text with a key set: in place of the line that has it, or offers it in a comment, else as the first of its
/// table, which is added where there is none.
std::string withKey(std::string_view text, const request::DefaultKey& key);

}  // namespace poinsot::cli
