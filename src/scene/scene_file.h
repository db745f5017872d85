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

/// Function that checks the TeX of a text. Returns what is wrong, or "" for valid TeX. Only the text library can
/// parse TeX, and the scene library must not depend on it.
using TextCheck = std::function<std::string(std::string_view)>;

/// Reads the text of a scene file.
/// @throws core::Error(kScene) if the file is missing, unreadable or not regular; core::Error(kLimit) if it has
/// more than Limit::kSceneBytes.
std::string readSceneText(const std::filesystem::path& path, const Limits& limits = {});

/// Reads a scene file and validates the scene.
/// @param overrides  values as after -D, such as "key.path=value"; a value that is not TOML counts as a string;
/// the last override of a key wins
/// @throws SceneErrors with all problems of the file and the overrides together; core::Error if readSceneText()
/// fails.
Scene loadScene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {},
                const TextCheck& textCheck = {}, const Allowance& allowance = {});

/// Validates the text of a scene.
/// @param fileName  name of the scene in messages; its folder is the scene's folder, in which files are searched
/// @throws SceneErrors, and nothing else, for any text.
Scene parseScene(std::string_view text, const std::string& fileName,
                 const std::vector<std::string>& overrides = {}, const TextCheck& textCheck = {},
                 const Allowance& allowance = {});

}  // namespace poinsot::scene
