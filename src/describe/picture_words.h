// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "request/requested_scene.h"

namespace poinsot::describe {

/// Metadata of a scene's picture files, UTF-8 without TeX, the same at every instant.
struct PictureWords {
  std::string title;        ///< title of the picture; the scene's name if the title is empty
  std::string description;  ///< alternative text for readers who do not see the picture; see altText()
};

/// @throws core::Error(kPhysics) if altText() or stage::StabilityMap throws
PictureWords pictureWords(const request::RequestedScene& requested);

}  // namespace poinsot::describe
