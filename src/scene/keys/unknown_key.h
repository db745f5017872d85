// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// What is said of a path that is no key of a scene.
namespace poinsot::scene {

/// "path: unknown key; did you mean ...?": a name beside it that is spelled alike, the key that people know by
/// this name, the same name in another table; else what there is.
std::string unknownKey(std::string_view path);

/// Of a path to a key of `array` that says not which element.
std::string withoutIndex(std::string_view path, std::string_view array);

/// The key or table directly below `table` that `name`, which is none, is spelled like.
std::optional<std::string> misspelt(std::string_view table, std::string_view name);

}  // namespace poinsot::scene
