// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"

namespace poinsot::bench {

/// Returns a picture similar to a frame, drawn without OpenGL: white, a plane with grid lines, a shaded ellipsoid
/// with its graticule visible through it, and a box. The shares of flat areas, gradients and soft edges are about
/// those of bench/standard.toml.
/// @param shift_px  shift to the right; a part of a pixel changes only edges, as another renderer does
image::Image guardPicture(image::PixelSize size, double shift_px);

}  // namespace poinsot::bench
