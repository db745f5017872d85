// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "image/image.h"
#include "loaded_scene.h"

namespace poinsot::python {

/// A picture that a caller asks for.
struct PictureAsk {
  std::optional<double> time_s;          ///< film time; none: the scene's time.still
  std::optional<image::PixelSize> size;  ///< in place of the scene's
  bool transparent = false;
  int bits = 8;
};

/// The picture, drawn as a film's frames are. From any thread: one thread of this module draws for all.
/// @throws core::Error(kUsage) for a time or size that there is not, as app::FramesCache::of().
image::AnyImage pictureOf(const LoadedScene& scene, const PictureAsk& ask);

/// The same as a PNG file.
std::vector<std::uint8_t> pngOf(const LoadedScene& scene, const PictureAsk& ask);

}  // namespace poinsot::python
