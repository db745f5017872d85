// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/abi.h"

namespace poinsot::compare {

/// Identifies what made a picture. A suite keeps it beside each reference, in NAME.json.
struct PictureOrigin {
  std::string renderer;  ///< GL_RENDERER; the variant of a picture that another program made; empty without one
  std::string driver;    ///< "Mesa 22.3.6"; empty for pictures of others, and where it was not recorded
  std::string software;  ///< "poinsot 0.1.0"
  std::string scene;     ///< SHA-256 of the scene and what it names, in hexadecimal; empty for pictures of others
};

/// Returns what made a new picture where its reference was made by another program, driver or renderer: "approved
/// by poinsot 0.1.0, drawn by poinsot 0.2.0". Facts that only one of the two has are left out; empty if none is
/// left.
std::string originChange(const PictureOrigin& approved, const PictureOrigin& drawn);

}  // namespace poinsot::compare
