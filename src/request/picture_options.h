// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "core/abi.h"

namespace poinsot::request {

/// Largest file of a picture that is copied or embedded, in bytes.
inline constexpr std::size_t kMostPicture = std::size_t{512} << 20;

/// A picture's width on paper. Type and lines are then sized in points, and its pixels are width times dpi.
struct PrintSize {
  double width_mm = 86;
  double dpi = 600;
};

/// How pictures are made, besides their size.
struct PictureOptions {
  std::optional<PrintSize> print;  ///< none: for a screen, type and lines sized by the picture
  bool transparent = false;        ///< without paper
  int bits = 8;                    ///< of a sample; 16 only where takesDeepPictures()
};

}  // namespace poinsot::request
