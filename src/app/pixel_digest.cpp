// SPDX-License-Identifier: Apache-2.0
#include "app/pixel_digest.h"

#include <fmt/format.h>

#include <span>
#include <variant>

#include "app/segment_record.h"
#include "core/sha256.h"
#include "image/png_file.h"

namespace poinsot::app {

std::string pixelDigest(const image::AnyImage& picture) {
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

std::string pixelDigestOf(const std::filesystem::path& file, bool isFilm) {
  return isFilm ? recordOf(file).sha256 : pixelDigest(image::readPngAsStored(file).picture);
}

}  // namespace poinsot::app
