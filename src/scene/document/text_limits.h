// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "scene/document/source.h"
#include "scene/limits.h"

namespace poinsot::scene {

struct LimitExceeded {
  Place place;
  std::string message;
};

/// Scans TOML text, before a parser builds a tree, for anything that would make the tree too large, too deep or
/// too slow. One pass in constant memory. For invalid TOML the result is arbitrary; the parser reports the error.
std::optional<LimitExceeded> exceededLimit(const Source& source, const Limits& limits);

/// Returns where an array begins that is still open at the start of a line; the innermost of several.
std::optional<Place> openArrayAtLine(const Source& source, const Limits& limits, int line);

}  // namespace poinsot::scene
