// SPDX-License-Identifier: Apache-2.0
// Included by .cpp files of this folder only.
#pragma once

#include "image/image.h"
#include "output/ffmpeg_handles.h"

namespace poinsot::output {

/// Puts a picture into a frame of its size, in the frame's own pixel format: one of those that FilmEncoder has.
void fillFrame(AVFrame& frame, const image::Image& picture);

/// What fillFrame() put into a frame of RGB bytes (BGRA, BGR0): with alpha where the format has it.
image::Image pictureOf(const AVFrame& frame);

}  // namespace poinsot::output
