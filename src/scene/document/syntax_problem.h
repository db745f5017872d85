// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "scene/document/source.h"
#include "scene/limits.h"

namespace poinsot::scene {

struct SyntaxProblem {
  Place place;
  std::string message;  ///< written for authors of scenes; names the usual slip
};

/// Translates a syntax error of the parser at a line and column.
/// @param description  message of toml++
SyntaxProblem syntaxProblem(const Source& source, int line, int column, std::string_view description,
                            const Limits& limits);

}  // namespace poinsot::scene
