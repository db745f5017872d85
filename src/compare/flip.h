// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "image/image.h"

namespace poinsot::compare {

/// Pixels per degree of a 0.7 m wide, 3840 pixel wide screen seen from 0.7 m: 3840 π / 180.
inline constexpr double kFlipPixelsPerDegree = 67.02064327658225;

/// What an eye that alternates between two pictures notices, per pixel in [0, 1], rows from the top.
struct FlipMap {
  image::PixelSize size;
  std::vector<double> error;

  double mean() const;
  double max() const;
};

/// A map in a few numbers. The median and the quartiles are weighted: half, a quarter, three quarters of the whole
/// error is in the pixels below them. All are 0 for equal pictures.
struct FlipFigures {
  double mean = 0, min = 0, firstQuartile = 0, median = 0, thirdQuartile = 0, max = 0;
};
/// @param pixels  number over which the mean is taken, if it is less than that of the map: the others have error 0
FlipFigures figuresOf(const FlipMap& map, std::optional<std::int64_t> pixels = {});

/// The FLIP difference of two sRGB pictures (alpha is left out), in double precision; symmetric in a and b.
/// @pre same size; pixelsPerDegree > 0.
/// Source: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild, "FLIP: A Difference Evaluator for
/// Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.
FlipMap flip(const image::Image& a, const image::Image& b, double pixelsPerDegree = kFlipPixelsPerDegree);
FlipMap flip(const image::DeepImage& a, const image::DeepImage& b, double pixelsPerDegree = kFlipPixelsPerDegree);

}  // namespace poinsot::compare
