// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace poinsot::scene {

/// Returns "path: unknown key; did you mean ...?". Suggests a similar name in the same table, the key that other
/// programs call by this name, or the same name in another table. Otherwise lists the names of the table.
std::string unknownKey(std::string_view path);

/// Returns the message for a path into the array of tables `array` that lacks the element's index.
std::string withoutIndex(std::string_view path, std::string_view array);

/// Returns the path of the key or table directly below `table` that the unknown `name` resembles.
std::optional<std::string> misspelt(std::string_view table, std::string_view name);

}  // namespace poinsot::scene
