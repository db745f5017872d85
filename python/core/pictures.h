// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "image/image.h"
#include "loaded_scene.h"

namespace poinsot::python {

struct PictureAsk {
  double time_s = 0;  ///< film time, from 0 to the film's duration
  image::PixelSize size;
  bool transparent = false;
  int bits = 8;  ///< bits per sample: 8 or 16
};

/// Checks the sides of a picture. @throws core::Error(kUsage) for a side too short, (kLimit) for one above the
/// limit.
void requireSides(std::int64_t width, std::int64_t height, const scene::Limits& limits);

/// Draws a picture like a frame of a film. Call it without the GIL, from any thread; one thread of this module
/// draws for all. After Ctrl-C, that thread finishes the picture on its own.
/// @throws core::Error as job::FramesCache::of(); (kUsage) in a fork of a process that has drawn.
image::AnyImage pictureOf(const std::shared_ptr<LoadedScene>& scene, const PictureAsk& ask);

std::vector<std::uint8_t> pngOf(const std::shared_ptr<LoadedScene>& scene, const PictureAsk& ask);

/// Waits for pictures in progress. Call it at the end of the process, before OpenGL's own data are destroyed.
void finishPictures();

}  // namespace poinsot::python
