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

/// Says what is wrong with a title, or nothing: its TeX is known to the text layer only, which this one cannot
/// see.
using TextCheck = std::function<std::string(std::string_view)>;

/// The text of a scene file.
/// @throws core::Error(kScene) for a file that is missing, unreadable, or not a regular file; (kLimit) for one of
/// more than Limit::kSceneBytes.
std::string readSceneText(const std::filesystem::path& path, const Limits& limits = {});

/// Reads a scene file. `overrides` are the words after -D, "key.path=value", where value is a TOML value or, when
/// it is none, text; the last of several for one key wins. `allowance` is what the user lets the scene have.
/// @throws SceneErrors with every problem of the file and the overrides at once;
/// core::Error(kScene) for a file that is missing, unreadable, or not a regular file.
Scene loadScene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {},
                const TextCheck& textCheck = {}, const Allowance& allowance = {});

/// The same for text in memory. `fileName` stands in messages, and gives the scene its name and the folder in
/// which the files that it names are looked for.
/// @throws SceneErrors, and nothing else, whatever the text.
Scene parseScene(std::string_view text, const std::string& fileName,
                 const std::vector<std::string>& overrides = {}, const TextCheck& textCheck = {},
                 const Allowance& allowance = {});

}  // namespace poinsot::scene
