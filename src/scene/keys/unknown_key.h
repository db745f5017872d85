// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace poinsot::scene {

// Far longer than any name. The edit distance of a long name from an untrusted scene takes too long.
constexpr std::size_t kLongestName = 64;

/// Returns the message "path: unknown key; did you mean ...?". Suggests a similar name in the same table, the key
/// for a name of another program, or the same name in another table. Otherwise lists the names in the table.
/// @param elsewhere  whether to suggest a key of another table
std::string unknownKey(std::string_view path, bool elsewhere = true);

/// Returns the message for a path into an array of tables that lacks the index of the element.
/// @param array  path of the array of tables
std::string withoutIndex(std::string_view path, std::string_view array);

/// Returns the path of a key with the same name in any table. Prefers keys outside arrays of tables.
std::optional<std::string> sameName(std::string_view name);

/// Returns the path of a key or a thing outside the table of a path, for a name that is right elsewhere.
std::optional<std::string> otherKey(std::string_view path);

/// Returns the table of this program for a table of other programs at the top level: "motion.torque" for "torque",
/// "time" for "film". Empty if there is none.
std::string tableElsewhere(std::string_view name);

/// Returns the path of the key or table in `table` whose name is most similar to `name`; empty if none is similar.
std::optional<std::string> misspelt(std::string_view table, std::string_view name);

}  // namespace poinsot::scene
