// SPDX-License-Identifier: Apache-2.0
#include "image/ink.h"

#include <algorithm>

#include "core/expect.h"

namespace poinsot::image {

PixelRect inkOf(const Image& image) {
  POINSOT_EXPECT(image.channels == 4);
  PixelRect ink{image.size.width, image.size.height, 0, 0};
  for (int y = 0; y < image.size.height; ++y)
    for (int x = 0; x < image.size.width; ++x) {
      if (image.at(x, y)[3] == 0) continue;
      ink = {std::min(ink.left, x), std::min(ink.top, y), std::max(ink.right, x + 1), std::max(ink.bottom, y + 1)};
    }
  return ink.empty() ? PixelRect{} : ink;
}

}  // namespace poinsot::image
