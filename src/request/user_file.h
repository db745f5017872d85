// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "scene/document/document.h"

namespace poinsot::request {

/// Where a user keeps a file of that name: $XDG_CONFIG_HOME/poinsot/NAME, else ~/.config/poinsot/NAME; empty where
/// the environment names neither folder.
std::filesystem::path userFile(std::string_view name);

/// Takes what a user's file says, an entry after the other; what is wrong goes to the problems. A file that is not
/// there says nothing.
/// @throws scene::SceneErrors with all problems and where; core::Error(kIo) if it cannot be read.
void readUserFile(const std::filesystem::path& file,
                  const std::function<void(const scene::Entry&, scene::Problems&)>& take);

}  // namespace poinsot::request
