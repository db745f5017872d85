// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace poinsot::app {

/// Where a user keeps a file of that name: $XDG_CONFIG_HOME/poinsot/NAME, else ~/.config/poinsot/NAME; empty where
/// the environment names neither folder.
std::filesystem::path userFile(std::string_view name);

}  // namespace poinsot::app
