// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"

namespace poinsot::bench {

/// The like of a frame without GL: white, a plane with grid lines, a shaded ellipsoid with its graticule seen
/// through, a box. Flat areas, gradients and soft edges in about the shares of bench/standard.toml.
/// @param shift_px  of all that is drawn, to the right: of a part of a pixel, and the picture differs at edges, as
/// that of another renderer does.
image::Image guardPicture(image::PixelSize size, double shift_px);

}  // namespace poinsot::bench
