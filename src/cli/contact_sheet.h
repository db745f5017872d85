// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "image/image.h"

namespace poinsot::cli {

/// Shrinks a picture to fit into `most`. Keeps the proportions, and never enlarges. Each pixel is the mean of the
/// linear light of the pixels that it covers. Returns RGB; transparent pixels are drawn over white.
image::Image shrunk(const image::Image& picture, image::PixelSize most);

/// Picture of a contact sheet. Its name is printed below as plain text, not as TeX.
struct SheetEntry {
  std::string name;
  image::Image picture;
};

/// Returns a contact sheet: pictures in reading order, with their names below, on light paper. The sheet has at
/// most five columns, and is otherwise about as wide as it is high.
/// @pre there is one at least.
image::Image contactSheet(const std::vector<SheetEntry>& entries);

}  // namespace poinsot::cli
