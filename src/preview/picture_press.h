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

/// Changes that the user made to the scene on the page. They apply to pictures and to the film.
struct PageChanges {
  std::vector<std::string> overrides;  ///< overrides that follow those of the command line
  std::optional<std::size_t> view;     ///< index of the view to draw; nullopt draws all views
};

struct PictureAsk {
  std::int64_t frame = 0;  ///< frame number; a number outside the film gives the first or last frame
  image::PixelSize size;   ///< size of the picture, instead of the scene's
  PageChanges changes;
};

/// Drawer of single frames, with the same pixels as in a film. Draws one frame at a time, on its own thread with
/// the only OpenGL context.
class PicturePress {
 public:
  PicturePress(const WatchedScene& scene, gl::Backend backend);
  ~PicturePress();
  PicturePress(const PicturePress&) = delete;
  PicturePress& operator=(const PicturePress&) = delete;

  /// Returns a picture as PNG, from the newest version of the scene without errors.
  /// @throws core::Error of the overrides or the back end, or if the scene has had errors since the start
  std::string png(const PictureAsk& ask);

 private:
  class Drawer;

  const WatchedScene& scene_;
  core::OwningThread<Drawer> drawer_;
};

}  // namespace poinsot::preview
