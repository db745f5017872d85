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

/// Looks over TOML text, before any parser builds a tree from it, for what would make that tree too large, too
/// deep or too slow: one pass, constant memory. Text that is not TOML passes or not; the parser says why.
std::optional<LimitExceeded> exceededLimit(const Source& source, const Limits& limits);

/// Where the array begins that is not closed yet where a line begins, by the same pass; the innermost of several.
std::optional<Place> openArrayAtLine(const Source& source, const Limits& limits, int line);

}  // namespace poinsot::scene
