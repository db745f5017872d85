// SPDX-License-Identifier: Apache-2.0
#include "image/pixel_digest.h"

#include <fmt/format.h>

#include <span>
#include <variant>

#include "core/sha256.h"

namespace poinsot::image {

std::string pixelDigest(const AnyImage& picture) {
  core::Sha256 sum;
  std::visit(
      [&](const auto& image) {
        sum.add(fmt::format("{}x{}x{}x{}\n", image.size.width, image.size.height, image.channels,
                            sizeof image.pixels[0]));
        sum.add(std::as_bytes(std::span(image.pixels)));
      },
      picture);
  return core::toHex(sum.finish());
}

}  // namespace poinsot::image
