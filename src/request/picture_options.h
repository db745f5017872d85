// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "core/abi.h"

namespace poinsot::request {

/// Largest picture file that may be copied or embedded, in bytes.
inline constexpr std::size_t kMostPicture = std::size_t{512} << 20;

/// Width of a picture on paper. Type and lines are then sized in points, and the width in pixels follows from dpi.
struct PrintSize {
  double width_mm = 86;
  double dpi = 600;
};

struct PictureOptions {
  std::optional<PrintSize> print;  ///< nullopt: for a screen; type and lines scale with the picture
  bool transparent = false;        ///< no paper behind the picture
  int bits = 8;                    ///< per sample; 16 only if takesDeepPictures()
};

}  // namespace poinsot::request
