// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "core/abi.h"

namespace poinsot::request {

/// Largest size of a picture file that can be copied or embedded, in bytes.
inline constexpr std::size_t kMostPicture = std::size_t{512} << 20;

/// Size of a picture on paper. Letters and lines then have sizes in points; dpi determines the width in pixels.
struct PrintSize {
  double width_mm = 86;
  double dpi = 600;
  std::optional<double> type_pt;  ///< one size for all small text, in points of 1/72 inch; nullopt: by layout
};

struct PictureOptions {
  std::optional<PrintSize> print;  ///< nullopt for a picture on a screen, whose letters scale with its size
  bool transparent = false;        ///< without the paper's colour behind the picture
  int bits = 8;                    ///< bits per sample, 8 or 16; 16 only if takesDeepPictures()
  bool crop = false;               ///< without empty borders
  bool svgText = false;            ///< writes the labels of an SVG as text and not as outlines
};

}  // namespace poinsot::request
