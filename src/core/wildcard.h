// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace poinsot::core {

/// Whether a text is what a pattern means: `*` stands for any run of characters, also for none, and `\*` for a
/// star; every other character, brackets included, for itself.
bool matchesWildcard(std::string_view pattern, std::string_view text);

/// The pattern that means this text only.
std::string wildcardOf(std::string_view text);

}  // namespace poinsot::core
