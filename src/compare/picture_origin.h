// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/abi.h"

namespace poinsot::compare {

/// Origin of a picture: the software and the scene that made it. Suites store the origin of a reference in
/// NAME.json.
struct PictureOrigin {
  std::string renderer;  ///< GL_RENDERER, or the variant of another program's picture; may be empty
  std::string driver;    ///< "Mesa 22.3.6"; empty if unknown, and for other programs' pictures
  std::string software;  ///< "poinsot 0.1.0"
  std::string scene;  ///< SHA-256 of the scene and its files, in hexadecimal; empty for other programs' pictures
};

/// Describes what changed between two origins, such as "approved by poinsot 0.1.0, drawn by poinsot 0.2.0".
/// Ignores facts that only one origin has. Returns an empty string if no fact changed.
std::string originChange(const PictureOrigin& approved, const PictureOrigin& drawn);

}  // namespace poinsot::compare
