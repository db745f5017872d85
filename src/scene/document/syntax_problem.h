// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "scene/document/source.h"
#include "scene/limits.h"

namespace poinsot::scene {

struct SyntaxProblem {
  Place place;
  std::string message;   ///< text of the error for the author of the scene; names the most likely mistake
  std::string mended{};  ///< the line in TOML, if the mistake has one likely correction; otherwise empty
};

/// Converts a syntax error of toml++ into a problem of the scene.
/// @param line  number of the line at which toml++ stopped
/// @param description  message of toml++
SyntaxProblem syntaxProblem(const Source& source, int line, int column, std::string_view description,
                            const Limits& limits);

}  // namespace poinsot::scene
