// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/document/problem.h"
#include "scene/limits.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Callback that returns the problem with a text's TeX; empty if there is none. Only the text library can parse
/// TeX, and this library may not use it.
using TextCheck = std::function<std::string(std::string_view)>;

/// Reads the text of a scene file.
/// @throws core::Error(kScene) if the file is missing, unreadable or not regular; (kLimit) if it has more than
/// Limit::kSceneBytes.
std::string readSceneText(const std::filesystem::path& path, const Limits& limits = {});

/// Reads a scene file.
/// @param overrides  "key.path=value" as after -D; a value that is not TOML counts as a string; the last override
/// of a key wins
/// @throws SceneErrors with all problems of the file and the overrides together; core::Error as readSceneText().
Scene loadScene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {},
                const TextCheck& textCheck = {}, const Allowance& allowance = {});

/// Parses a scene in memory.
/// @param fileName  for messages; also gives the scene its name and the folder in which it finds its files
/// @throws SceneErrors, and nothing else, for any text.
Scene parseScene(std::string_view text, const std::string& fileName,
                 const std::vector<std::string>& overrides = {}, const TextCheck& textCheck = {},
                 const Allowance& allowance = {});

}  // namespace poinsot::scene
