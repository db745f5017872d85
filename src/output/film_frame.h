// SPDX-License-Identifier: Apache-2.0
// This header is included by .cpp files of this folder only.
#pragma once

#include <span>

#include "image/image.h"
#include "output/ffmpeg_handles.h"

namespace poinsot::output {

/// Converts a picture into a frame of the same size, in any pixel format that FilmEncoder uses.
void fillFrame(AVFrame& frame, const image::Image& picture);
/// Converts only the rectangles `changed`, into a frame that already holds the rest of the picture.
void fillFrame(AVFrame& frame, const image::Image& picture, std::span<const image::PixelRect> changed);

/// Returns the picture in a frame of RGB bytes (BGRA or BGR0) that fillFrame() filled; BGRA has alpha.
image::Image pictureOf(const AVFrame& frame);

}  // namespace poinsot::output
