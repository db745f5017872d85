// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "request/requested_scene.h"

namespace poinsot::describe {

/// What the files of a scene's pictures say of themselves, UTF-8 without TeX: the same for every instant.
struct PictureWords {
  std::string title;        ///< the picture's, or the scene's name
  std::string description;  ///< altText(): for those who do not see it
};

/// @throws core::Error(kPhysics) as altText() and stage::StabilityMap.
PictureWords pictureWords(const request::RequestedScene& requested);

}  // namespace poinsot::describe
