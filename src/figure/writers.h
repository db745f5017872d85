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

  double pointsPerPixel() const;  ///< length of a pixel's side in points of 1/72 inch
  double dpi() const { return 72 / pointsPerPixel(); }
  /// Returns whether the picture has an opaque background. If not, halos of labels are holes in the image part.
  bool hasPaper() const { return imagePart.channels == 3; }
};

using Bytes = std::vector<std::uint8_t>;

Bytes pdfOf(const Figure& figure);
std::string svgOf(const Figure& figure);

/// @param imageName  name of the PNG with the image part, in the folder of the TeX file.
std::string tikzOf(const Figure& figure, const std::string& imageName);

}  // namespace poinsot::figure
