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

/// Returns the first limit that a TOML text exceeds: nesting depth, number of values, length of a string or of the
/// text. Call this before the parser builds its tree. Scans the text once, with little memory. For invalid TOML
/// the result is arbitrary, because the parser reports the error.
std::optional<LimitExceeded> exceededLimit(const Source& source, const Limits& limits);

/// Returns the opening bracket of the innermost array that is open at the start of a line; empty if none is.
std::optional<Place> openArrayAtLine(const Source& source, const Limits& limits, int line);

}  // namespace poinsot::scene
