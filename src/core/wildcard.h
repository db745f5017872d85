// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace poinsot::core {

/// Returns whether a text matches a pattern. `*` matches any run of characters, also an empty one; `\*` matches a
/// star and `\\` a backslash. Every other character, brackets included, matches itself.
bool matchesWildcard(std::string_view pattern, std::string_view text);

/// Returns a pattern that matches only this text.
std::string wildcardOf(std::string_view text);

}  // namespace poinsot::core
