// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>

#include "gl/offscreen_context.h"
#include "job/scene_frames.h"
#include "request/picture_options.h"

namespace poinsot::job {

/// Cache of recently used scenes that are ready to draw, on one OpenGL context. The first scene opens the context.
/// Create, use and destroy the cache on the same thread.
class FramesCache {
 public:
  struct Entry {
    std::string key;
    std::int64_t count = 0;  ///< number of frames in the film
    std::unique_ptr<SceneFrames> frames;
  };

  explicit FramesCache(gl::Backend backend) : backend_(backend) {}

  /// Returns the frames of a scene from the cache, or loads the scene. The result is valid until the next call.
  /// @param key  identifies the scene and `form`; equal keys return the same entry
  /// @throws core::Error from `load` or the back end; core::Error(kLimit) if a picture needs more memory than
  /// allowed
  Entry& of(const std::string& key, const std::function<request::RequestedScene()>& load,
            const request::PictureOptions& form);

  void clear() { entries_.clear(); }

 private:
  gl::Backend backend_;
  std::unique_ptr<gl::OffscreenContext> context_;
  std::list<Entry> entries_;  // most recently used entry first; destroyed before the context
};

}  // namespace poinsot::job
