// SPDX-License-Identifier: Apache-2.0
#include "app/picture_diff.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <system_error>
#include <variant>

#include "app/memory.h"
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

DiffPicture read(const std::filesystem::path& file) {
  image::PngPicture png = image::readPngAsStored(file);
  return {std::move(png.picture), png.channels};
}

}  // namespace

std::string reasonOf(const PictureDiff& diff) {
  return diff.mismatch.empty() ? fmt::format("{}", fmt::join(diff.excesses, ", ")) : diff.mismatch;
}

ComparedPictures comparePictures(DiffPicture reference, DiffPicture test, const DiffRequest& request) {
  ComparedPictures compared{std::move(reference), std::move(test), {}, {}};
  PictureDiff& diff = compared.diff;
  diff.size = sizeOf(compared.reference.pixels);
  diff.channels = compared.reference.channels;
  diff.mismatch = mismatchOf(compared.reference, compared.test);
  if (!diff.mismatch.empty()) return compared;
  expectWithinMemory(compareMemory_bytes(diff.size),
                     fmt::format("comparing pictures of {}x{}", diff.size.width, diff.size.height),
                     request.limits);
  image::Comparison made =
      image::compare(compared.reference.pixels, compared.test.pixels, request.pixelsPerDegree);
  compared.flip = std::move(made.flip);
  diff.figures = std::move(made.difference);
  diff.verdict = image::verdict(diff.figures, request.rule);
  if (diff.verdict == image::Verdict::kDifferent) diff.excesses = image::excesses(diff.figures, request.rule);
  return compared;
}

ComparedPictures compareFiles(const std::filesystem::path& reference, const std::filesystem::path& test,
                              const DiffRequest& request) {
  return comparePictures(read(reference), read(test), request);
}

void forgetMaps(const DiffRequest& request) {
  for (const auto& place : {request.map, request.difference}) {
    std::error_code ignored;  // what stays is overwritten or refused later
    if (place && image::isOwnPng(*place)) std::filesystem::remove(*place, ignored);
  }
}

void writeMaps(const ComparedPictures& compared, const DiffRequest& request) {
  if (!compared.diff.mismatch.empty()) return forgetMaps(request);
  if (request.map) output::writePng(*request.map, image::magmaPicture(compared.flip));
  if (request.difference)
    output::writePng(*request.difference,
                     image::amplifiedDifference(compared.reference.pixels, compared.test.pixels));
}

}  // namespace poinsot::app
