// SPDX-License-Identifier: Apache-2.0
// This header is included by .cpp files of this folder only.
#pragma once

#include <span>

#include "image/image.h"
#include "output/ffmpeg_handles.h"

namespace poinsot::output {

/// Converts a picture into a frame of the same size, in any pixel format that FilmEncoder uses.
void fillFrame(AVFrame& frame, const image::Image& picture);
/// Converts only the rectangles `changed`. The frame must already contain the rest of the picture.
void fillFrame(AVFrame& frame, const image::Image& picture, std::span<const image::PixelRect> changed);

/// Returns the picture of a frame that fillFrame() filled in format BGRA or BGR0. A picture from BGRA has alpha.
image::Image pictureOf(const AVFrame& frame);

}  // namespace poinsot::output
