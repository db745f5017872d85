// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "image/image.h"

namespace poinsot::compare {

/// Default visual resolution in pixels per degree: 3840 π / 180. A screen that is 0.7 m and 3840 pixels wide has
/// this resolution if seen from 0.7 m.
inline constexpr double kFlipPixelsPerDegree = 67.02064327658225;

/// Perceived difference between two pictures that are shown alternately. `error` has a value in [0, 1] for each
/// pixel, the top row first.
struct FlipMap {
  image::PixelSize size;
  std::vector<double> error;

  double mean() const;
  double max() const;
};

/// Summary of a FLIP map. The median is weighted: pixels below it have half of the total error. The quartiles are
/// weighted in the same way. All figures are 0 for equal pictures.
struct FlipFigures {
  double mean = 0, min = 0, firstQuartile = 0, median = 0, thirdQuartile = 0, max = 0;
};
/// Summarises a FLIP map.
/// @param pixels  number of pixels over which the mean is taken, if some pixels of the map do not count; their
///   errors must be 0
FlipFigures figuresOf(const FlipMap& map, std::optional<std::int64_t> pixels = {});

/// Returns the FLIP difference of two sRGB pictures in double precision; symmetric in a and b. Alpha is ignored.
/// @pre same size; pixelsPerDegree > 0.
/// Source: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild, "FLIP: A Difference Evaluator for
/// Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.
FlipMap flip(const image::Image& a, const image::Image& b, double pixelsPerDegree = kFlipPixelsPerDegree);
FlipMap flip(const image::DeepImage& a, const image::DeepImage& b, double pixelsPerDegree = kFlipPixelsPerDegree);

}  // namespace poinsot::compare
