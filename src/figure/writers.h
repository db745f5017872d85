// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "figure/figure.h"

/// The three media, each as the bytes of its file.
namespace poinsot::figure {

/// A figure about to be written.
struct Figure {
  const draw::Picture& picture;
  const image::Image& imagePart;
  const FigureOptions& options;

  double pointsPerPixel() const;  ///< points of 1/72 inch
  double dpi() const { return 72 / pointsPerPixel(); }
  /// Without paper a label has no halo of paper; in the image part it is a hole.
  bool hasPaper() const { return imagePart.channels == 3; }
};

using Bytes = std::vector<std::uint8_t>;

Bytes pdfOf(const Figure& figure);
std::string svgOf(const Figure& figure);

/// @param imageName of the image part's PNG, beside the file.
std::string tikzOf(const Figure& figure, const std::string& imageName);

}  // namespace poinsot::figure
