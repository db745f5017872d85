// SPDX-License-Identifier: Apache-2.0
#include "app/picture_diff.h"

#include <fmt/format.h>

#include <variant>

#include "image/magma.h"
#include "image/png_file.h"
#include "output/png_sequence.h"

namespace poinsot::app {
namespace {

image::PixelSize sizeOf(const image::AnyImage& picture) {
  return std::visit([](const auto& p) { return p.size; }, picture);
}

/// Why two pictures have no differences of pixels. Nothing is resized.
std::string mismatchOf(const DiffPicture& reference, const DiffPicture& test) {
  const image::PixelSize a = sizeOf(reference.pixels), b = sizeOf(test.pixels);
  if (a != b) return fmt::format("the size is {}x{}, not {}x{}", b.width, b.height, a.width, a.height);
  constexpr const char* kKinds[] = {"", "grey", "grey and alpha", "RGB", "RGB and alpha"};
  if (reference.channels != test.channels)
    return fmt::format("the channels are {} ({}), not {} ({})", test.channels, kKinds[test.channels],
                       reference.channels, kKinds[reference.channels]);
  return "";
}

void writePictures(const DiffPicture& reference, const DiffPicture& test, const image::FlipMap& map,
                   const DiffRequest& request) {
  if (request.map) output::writePng(*request.map, image::magmaPicture(map));
  if (request.difference)
    output::writePng(*request.difference, image::amplifiedDifference(reference.pixels, test.pixels));
}

DiffPicture read(const std::filesystem::path& file) {
  image::PngPicture png = image::readPngAsStored(file);
  return {std::move(png.picture), png.channels};
}

}  // namespace

PictureDiff diffPictures(const DiffPicture& reference, const DiffPicture& test, const DiffRequest& request) {
  PictureDiff diff;
  diff.size = sizeOf(reference.pixels);
  diff.channels = reference.channels;
  diff.mismatch = mismatchOf(reference, test);
  if (!diff.mismatch.empty()) return diff;
  image::Comparison made = image::compare(reference.pixels, test.pixels, request.pixelsPerDegree);
  diff.figures = std::move(made.difference);
  diff.verdict = image::verdict(diff.figures, request.rule);
  if (diff.verdict == image::Verdict::kDifferent) diff.excesses = image::excesses(diff.figures, request.rule);
  writePictures(reference, test, made.flip, request);
  return diff;
}

PictureDiff diffFiles(const std::filesystem::path& reference, const std::filesystem::path& test,
                      const DiffRequest& request) {
  return diffPictures(read(reference), read(test), request);
}

}  // namespace poinsot::app
