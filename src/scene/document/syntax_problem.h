// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "scene/document/source.h"
#include "scene/limits.h"

namespace poinsot::scene {

/// Why a text is no TOML.
struct SyntaxProblem {
  Place place;
  std::string message;  ///< in the words of someone who writes scenes, with the usual slip named
};

/// From what the parser says, where it stopped.
SyntaxProblem syntaxProblem(const Source& source, int line, int column, std::string_view description,
                            const Limits& limits);

}  // namespace poinsot::scene
