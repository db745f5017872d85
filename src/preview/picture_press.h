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
  std::vector<std::string> overrides;  ///< after those of the command line
  std::optional<std::size_t> view;     ///< that view alone; none: the whole picture
};

/// A picture that a page asks for.
struct PictureAsk {
  std::int64_t frame = 0;  ///< the last one where the film has fewer
  image::PixelSize size;   ///< in place of the scene's
  PageChanges changes;
};

/// Draws frames as a film's worker does, one after the other, on a thread that has the one OpenGL context.
class PicturePress {
 public:
  PicturePress(const WatchedScene& scene, gl::Backend backend);
  ~PicturePress();
  PicturePress(const PicturePress&) = delete;
  PicturePress& operator=(const PicturePress&) = delete;

  /// The picture as PNG, of the newest scene without a mistake.
  /// @throws core::Error of the overrides or the back end, or when there was no such scene yet.
  std::string png(const PictureAsk& ask);

 private:
  class Drawer;

  const WatchedScene& scene_;
  core::OwningThread<Drawer> drawer_;
};

}  // namespace poinsot::preview
