// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "figure/figure.h"

namespace poinsot::figure {

struct Figure {
  const draw::Picture& picture;
  const image::Image& imagePart;
  const FigureOptions& options;

  double pointsPerPixel() const;  ///< in points of 1/72 inch
  double dpi() const { return 72 / pointsPerPixel(); }
  /// Returns whether the picture has paper. Without paper, a label has no halo of paper; its halo is a hole in the
  /// image part.
  bool hasPaper() const { return imagePart.channels == 3; }
};

using Bytes = std::vector<std::uint8_t>;

Bytes pdfOf(const Figure& figure);
std::string svgOf(const Figure& figure);

/// @param imageName  name of the image part's PNG, which is beside the TeX file.
std::string tikzOf(const Figure& figure, const std::string& imageName);

}  // namespace poinsot::figure
