// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fine_picture.h"

namespace poinsot::render {

/// How far a picture's edges are from what they should be: of the pixels that an edge runs through, and of their
/// three channels, the absolute differences in sRGB, in 1/255.
struct EdgeError {
  double mean = 0;
  int worst = 0, count = 0;  ///< count: of edge pixels
};

/// Says what it finds under `name`. With EDGE_PICTURES=FOLDER in the environment the picture is written there, as
/// it is, as it should be, and eight times their difference.
EdgeError edgeError(const image::Image& picture, const FinePicture& fine, const std::string& name);

}  // namespace poinsot::render
