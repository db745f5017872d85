// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace poinsot::layering {

/// Something named in a file: the header of an include, or a linked target.
struct Mention {
  int line = 0;  ///< from 1
  std::string name;
  bool quoted = false;  ///< of an include: "..." and not <...>
};

/// The #includes of C++ source, comments left out. A header named by a macro (FT_FREETYPE_H) is that macro's name.
std::vector<Mention> includesOf(std::string_view source);

/// The layers that a CMakeLists.txt names as poinsot::X or poinsot_X, comments left out; `layers` are all there
/// are.
std::vector<Mention> layersLinkedIn(std::string_view cmake, const std::vector<std::string>& layers);

}  // namespace poinsot::layering
