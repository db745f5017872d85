// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "image/image.h"

namespace poinsot::compare {

/// Pixels per degree of a 0.7 m wide, 3840 pixel wide screen seen from 0.7 m: 3840 π / 180.
inline constexpr double kFlipPixelsPerDegree = 67.02064327658225;

/// Perceived difference when alternating between two pictures: an error in [0, 1] per pixel, rows from the top.
struct FlipMap {
  image::PixelSize size;
  std::vector<double> error;

  double mean() const;
  double max() const;
};

/// Summary of a map. Median and quartiles are weighted: the pixels below them hold half, a quarter and three
/// quarters of the total error. All figures are 0 for equal pictures.
struct FlipFigures {
  double mean = 0, min = 0, firstQuartile = 0, median = 0, thirdQuartile = 0, max = 0;
};
/// Summarises a map. @param pixels  number of pixels for the mean, if fewer than the map has; the others have
/// error 0
FlipFigures figuresOf(const FlipMap& map, std::optional<std::int64_t> pixels = {});

/// Returns the FLIP difference of two sRGB pictures in double precision; symmetric in a and b. Alpha is ignored.
/// @pre same size; pixelsPerDegree > 0.
/// Source: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild, "FLIP: A Difference Evaluator for
/// Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.
FlipMap flip(const image::Image& a, const image::Image& b, double pixelsPerDegree = kFlipPixelsPerDegree);
FlipMap flip(const image::DeepImage& a, const image::DeepImage& b, double pixelsPerDegree = kFlipPixelsPerDegree);

}  // namespace poinsot::compare
