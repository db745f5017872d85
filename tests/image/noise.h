// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>

#include "image/image.h"

namespace poinsot::image {

/// Returns a picture of random samples, the same for the same seed.
inline Image noise(PixelSize size, unsigned seed, int channels = 3) {
  Image picture(size, channels);
  std::mt19937 random(seed);
  for (auto& v : picture.pixels) v = static_cast<std::uint8_t>(random());
  return picture;
}

}  // namespace poinsot::image
