// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "image/image.h"

namespace poinsot::cli {

/// The picture at the largest size that fits into `most` without enlarging or distorting it: each pixel is the
/// mean of the light that falls on it. RGB; a fourth channel is laid over white.
image::Image shrunk(const image::Image& picture, image::PixelSize most);

/// One picture of a sheet and what stands under it, as it is: no TeX.
struct SheetEntry {
  std::string name;
  image::Image picture;
};

/// Pictures side by side with their names under them, on light paper with even margins, in the order of reading.
/// A row holds about as many as make the sheet as wide as it is high, four to five in sixteen to nine.
/// @pre there is one at least.
image::Image contactSheet(const std::vector<SheetEntry>& entries);

}  // namespace poinsot::cli
