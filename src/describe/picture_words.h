// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "request/requested_scene.h"

namespace poinsot::describe {

/// Texts that all picture files of a scene contain as metadata. UTF-8, no TeX, the same at every instant.
struct PictureWords {
  std::string title;        ///< picture's title, or the scene's name if there is no title
  std::string description;  ///< altText(), for readers who do not see the picture
};

/// @throws core::Error(kPhysics) if altText() or stage::StabilityMap throws
PictureWords pictureWords(const request::RequestedScene& requested);

}  // namespace poinsot::describe
