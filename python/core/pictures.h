// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "image/image.h"
#include "loaded_scene.h"

namespace poinsot::python {

/// A picture that a caller asks for.
struct PictureAsk {
  double time_s = 0;  ///< film time, from 0 to the film's duration
  image::PixelSize size;
  bool transparent = false;
  int bits = 8;  ///< of a sample: 8 or 16
};

/// @throws core::Error(kUsage) for a side that is too short, (kLimit) for one beyond the scene's limit.
void requireSides(std::int64_t width, std::int64_t height, const scene::Limits& limits);

/// The picture, drawn as a film's frames are. Call it without the GIL, from any thread: one thread of this module
/// draws for all. After Ctrl-C that thread finishes the picture alone.
/// @throws core::Error as job::FramesCache::of(); (kUsage) in a fork of a process that has drawn.
image::AnyImage pictureOf(const std::shared_ptr<LoadedScene>& scene, const PictureAsk& ask);

/// The same as a PNG file.
std::vector<std::uint8_t> pngOf(const std::shared_ptr<LoadedScene>& scene, const PictureAsk& ask);

/// Waits for what is still being drawn: at the process's end, when OpenGL's own data are about to go.
void finishPictures();

}  // namespace poinsot::python
