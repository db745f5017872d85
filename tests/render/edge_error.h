// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fine_picture.h"

namespace poinsot::render {

/// Error of a picture's edges: absolute differences in sRGB, in 1/255, over the three channels of all pixels that
/// an edge runs through.
struct EdgeError {
  double mean = 0;
  int worst = 0, count = 0;  ///< count: number of edge pixels
};

/// Compares the edge pixels of `picture` with `fine` and prints the result under `name`. If EDGE_PICTURES=FOLDER
/// is set in the environment, also writes the picture, the expected one and eight times their difference there.
EdgeError edgeError(const image::Image& picture, const FinePicture& fine, const std::string& name);

}  // namespace poinsot::render
