// SPDX-License-Identifier: Apache-2.0
#include "compare/magma.h"

#include <algorithm>
#include <cmath>

#include "core/magma.h"

namespace poinsot::compare {

image::Image magmaPicture(const FlipMap& map) {
  image::Image picture(map.size, 3);
  auto* p = picture.pixels.data();
  for (const double error : map.error)
    p = std::ranges::copy(core::magma(static_cast<std::size_t>(std::lround(255 * std::clamp(error, 0.0, 1.0)))), p)
            .out;
  return picture;
}

}  // namespace poinsot::compare
