// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/owning_thread.h"
#include "gl/offscreen_context.h"
#include "image/image.h"
#include "preview/watched_scene.h"

namespace poinsot::preview {

/// Changes that a page makes to the scene, for its pictures and for its film.
struct PageChanges {
  std::vector<std::string> overrides;  ///< applied after those of the command line
  std::optional<std::size_t> view;     ///< index of the only view to draw; nullopt draws the whole picture
};

struct PictureAsk {
  std::int64_t frame = 0;  ///< clamped to the frames of the film
  image::PixelSize size;   ///< replaces the scene's size
  PageChanges changes;
};

/// Draws frames as a film's worker does, one at a time, on the thread that owns the only OpenGL context.
class PicturePress {
 public:
  PicturePress(const WatchedScene& scene, gl::Backend backend);
  ~PicturePress();
  PicturePress(const PicturePress&) = delete;
  PicturePress& operator=(const PicturePress&) = delete;

  /// Returns a picture of the newest scene without errors, as PNG.
  /// @throws core::Error of the overrides or the back end, or if no scene without errors exists yet
  std::string png(const PictureAsk& ask);

 private:
  class Drawer;

  const WatchedScene& scene_;
  core::OwningThread<Drawer> drawer_;
};

}  // namespace poinsot::preview
