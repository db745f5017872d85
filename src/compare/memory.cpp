// SPDX-License-Identifier: Apache-2.0
#include "compare/memory.h"

#include <algorithm>

namespace poinsot::compare {
namespace {

constexpr double kFilmsStart_bytes = 56e6;  // memory of FFmpeg 7's libraries, loaded for films only
constexpr double kLeastReading_bytes = 9;   // least memory per pixel for reading two films
constexpr double kGaps = 1.1;               // factor for gaps that freed frames leave in the heap

/// Returns the bytes per pixel that a comparison takes if all pixels differ. Transparent pictures take more,
/// because they are compared on two backgrounds.
double comparePixel_bytes(PixelKind kind) {
  // Measured bytes per pixel, with 2560x1440 pixels of noise: 28.4 (8 bits), 41 (16), 45 (8 with alpha), 69 (16
  // with alpha).
  if (kind.deep) return kind.transparent ? 70 : 42;
  return kind.transparent ? 48 : 29;
}

}  // namespace

double compareMemory_bytes(image::PixelSize size, PixelKind kind) {
  constexpr double kStart_bytes = 16e6;
  return kStart_bytes + comparePixel_bytes(kind) * size.width * size.height;
}

// The constants were measured, see tests/faults/film_memory_test.cpp.
double compareFilmsMemory_bytes(image::PixelSize size, PixelKind kind, std::optional<double> reading_bytes,
                                int jobs) {
  const double pixels = 1.0 * size.width * size.height;
  return kFilmsStart_bytes + reading_bytes.value_or(kLeastReading_bytes * pixels) +
         kGaps * jobs * comparePixel_bytes(kind) * pixels;
}

double largestFilmPicture_pixels(double bytes) {
  return std::max(0.0, bytes - kFilmsStart_bytes) / (kLeastReading_bytes + kGaps * comparePixel_bytes({}));
}

}  // namespace poinsot::compare
