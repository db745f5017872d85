// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/color.h"
#include "image/image.h"
#include "render/mosaic.h"
#include "render/tile_cache.h"

namespace poinsot::render {

/// Pixels of a picture or of one of its panels, kept from picture to picture. Only tiles that have changed since
/// the previous picture are drawn and read again.
class CachedPanel {
 public:
  /// Starts a picture and returns its cache of tiles. Pixels kept from before are dropped if size or channels
  /// differ.
  /// @param common  numbers, besides size and format, that all tiles depend on
  template <typename Sample>
  TileCache& begin(image::PixelSize size, bool transparent, Constants common);
  /// Reads the drawn tiles of the mosaic from the bound framebuffer and fills its empty tiles with the background.
  template <typename Sample>
  void read(const Mosaic& mosaic, const draw::Color& background);
  /// Fills these parts with the background. Alpha, if present, is set to 0.
  template <typename Sample>
  void layPaper(const std::vector<PixelBounds>& parts, const draw::Color& background);
  /// Marks places as painted over, so that the next picture draws their tiles again.
  void forget(const std::vector<PixelBounds>& places);
  /// Marks the picture as complete. Without this call, the next picture reuses none of its tiles.
  void end() { tiles_.endPicture(); }

  template <typename Sample>
  image::BasicImage<Sample>& picture() {
    return std::get<image::BasicImage<Sample>>(picture_);
  }
  const image::AnyImage& any() const { return picture_; }
  /// Returns where the picture may differ from the previous picture in this place.
  const std::vector<image::PixelRect>& changed() const { return changed_; }

 private:
  void markChanged(const PixelBounds& place);

  image::AnyImage picture_;
  std::vector<image::PixelRect> changed_;
  TileCache tiles_;
};

}  // namespace poinsot::render
