// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace poinsot::layering {

/// Name that a file mentions: the header of an include, or a linked target.
struct Mention {
  int line = 0;  ///< from 1
  std::string name;
  bool quoted = false;  ///< include with "..." instead of <...>
};

/// Returns the #includes of C++ source, without those in comments. A header that a macro names (FT_FREETYPE_H) has
/// the name of the macro.
std::vector<Mention> includesOf(std::string_view source);

/// Returns the layers that a CMakeLists.txt names as poinsot::X or poinsot_X outside of comments.
/// @param layers  names of all layers
std::vector<Mention> layersLinkedIn(std::string_view cmake, const std::vector<std::string>& layers);

}  // namespace poinsot::layering
