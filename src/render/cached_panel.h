// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/color.h"
#include "image/image.h"
#include "render/mosaic.h"
#include "render/tile_cache.h"

namespace poinsot::render {

/// The pixels of a picture or a panel of it, kept for the one in its place in the next picture: only what became
/// different is drawn and read again.
class CachedPanel {
 public:
  /// The tiles of the picture that begins. @param common  the numbers that all tiles depend on, beside size and
  /// kind
  template <typename Sample>
  TileCache& begin(image::PixelSize size, bool transparent, Constants common);
  /// From the bound framebuffer, where the mosaic was drawn; paper is laid without asking it.
  template <typename Sample>
  void read(const Mosaic& mosaic, const draw::Color& background);
  /// Puts nothing there.
  template <typename Sample>
  void layPaper(const std::vector<PixelBounds>& parts, const draw::Color& background);
  /// Something was painted over the picture there.
  void forget(const std::vector<PixelBounds>& places);
  /// The picture is whole. If this is not reached, nothing of it is kept.
  void end() { tiles_.endPicture(); }

  template <typename Sample>
  image::BasicImage<Sample>& picture() {
    return std::get<image::BasicImage<Sample>>(picture_);
  }
  const image::AnyImage& any() const { return picture_; }
  /// Where it may differ from the picture before it in this place.
  const std::vector<image::PixelRect>& changed() const { return changed_; }

 private:
  void markChanged(const PixelBounds& place);

  image::AnyImage picture_;
  std::vector<image::PixelRect> changed_;
  TileCache tiles_;
};

}  // namespace poinsot::render
