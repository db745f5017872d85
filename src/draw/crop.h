// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/picture.h"

namespace poinsot::draw {

/// Returns the part of a picture in a rectangle, without a change of scale or perspective.
/// @param origin_px, size_px  rectangle in pixels from the top left corner, y down
/// @pre the rectangle is not empty and lies in the picture.
Picture cropped(const Picture& picture, glm::ivec2 origin_px, glm::ivec2 size_px);

}  // namespace poinsot::draw
