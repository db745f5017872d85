// SPDX-License-Identifier: Apache-2.0
// Included by .cpp files of this folder only.
#pragma once

#include <span>

#include "image/image.h"
#include "output/ffmpeg_handles.h"

namespace poinsot::output {

/// Puts a picture into a frame of its size, in the frame's own pixel format: one of those that FilmEncoder has.
void fillFrame(AVFrame& frame, const image::Image& picture);
/// The same for a frame that holds a picture that differs from this one in those parts only.
void fillFrame(AVFrame& frame, const image::Image& picture, std::span<const image::PixelRect> changed);

/// What fillFrame() put into a frame of RGB bytes (BGRA, BGR0): with alpha where the format has it.
image::Image pictureOf(const AVFrame& frame);

}  // namespace poinsot::output
