// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "image/image.h"

namespace poinsot::cli {

/// Shrinks a picture to fit into `most`, without distorting or enlarging it. Each pixel is the mean of the light
/// that falls on it. Returns RGB; a fourth channel is laid over white.
image::Image shrunk(const image::Image& picture, image::PixelSize most);

/// Picture of a sheet, with the name below it as plain text without TeX.
struct SheetEntry {
  std::string name;
  image::Image picture;
};

/// Returns a sheet of pictures with their names below, on light paper with even margins, in reading order. The
/// number of columns makes the sheet about as wide as it is high, and is at most five.
/// @pre there is one at least.
image::Image contactSheet(const std::vector<SheetEntry>& entries);

}  // namespace poinsot::cli
