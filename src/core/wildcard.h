// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace poinsot::core {

/// Returns whether a text matches a pattern. `*` matches any number of characters, even none. `\*` matches a star,
/// and `\\` matches a backslash. Every other character, including brackets, matches itself.
bool matchesWildcard(std::string_view pattern, std::string_view text);

/// Returns a pattern that matches only this text.
std::string wildcardOf(std::string_view text);

}  // namespace poinsot::core
