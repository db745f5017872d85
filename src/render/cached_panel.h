// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/color.h"
#include "image/image.h"
#include "render/mosaic.h"
#include "render/tile_cache.h"

namespace poinsot::render {

/// Pixels of a picture, or of one panel of a picture, kept from one frame to the next. Only tiles that have
/// changed since the previous frame are drawn and read back.
class CachedPanel {
 public:
  /// Starts a picture and returns the cache of its tiles. Discards the pixels of the previous picture if the size
  /// or the number of channels has changed.
  /// @param common  numbers that the pixels of all tiles depend on, apart from size and format
  template <typename Sample>
  TileCache& begin(image::PixelSize size, bool transparent, Constants common);
  /// Reads the drawn tiles of the mosaic back from the bound framebuffer. Fills the empty tiles.
  template <typename Sample>
  void read(const Mosaic& mosaic, const draw::Color& background);
  /// Fills the given rectangles with the background colour. Alpha, if present, is set to 0.
  template <typename Sample>
  void layPaper(const std::vector<PixelBounds>& parts, const draw::Color& background);
  /// Marks rectangles as painted over, such as by a label. The next picture draws their tiles again.
  void forget(const std::vector<PixelBounds>& places);
  /// Marks the picture as complete. Without this call, the next picture redraws all tiles.
  void end() { tiles_.endPicture(); }

  template <typename Sample>
  image::BasicImage<Sample>& picture() {
    return std::get<image::BasicImage<Sample>>(picture_);
  }
  const image::AnyImage& any() const { return picture_; }
  /// Returns the rectangles in which the picture may differ from the previous picture of this panel.
  const std::vector<image::PixelRect>& changed() const { return changed_; }

 private:
  void markChanged(const PixelBounds& place);

  image::AnyImage picture_;
  std::vector<image::PixelRect> changed_;
  TileCache tiles_;
};

}  // namespace poinsot::render
