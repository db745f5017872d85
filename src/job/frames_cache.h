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

/// Scenes that are ready to draw: the latest few, on one OpenGL context, which is opened for the first. For one
/// thread, from its making to its end.
class FramesCache {
 public:
  struct Entry {
    std::string key;
    std::int64_t count = 0;  ///< of the film's frames
    std::unique_ptr<SceneFrames> frames;
  };

  explicit FramesCache(gl::Backend backend) : backend_(backend) {}

  /// The frames of the scene that `key` stands for, which is loaded where they are not at hand. Good until the
  /// next call.
  /// @throws core::Error of `load`, of the back end; (kLimit) for a picture that takes more memory than allowed.
  Entry& of(const std::string& key, const std::function<request::RequestedScene()>& load,
            const request::PictureOptions& form);

  void clear() { entries_.clear(); }

 private:
  gl::Backend backend_;
  std::unique_ptr<gl::OffscreenContext> context_;
  std::list<Entry> entries_;  // the latest first; gone before the context
};

}  // namespace poinsot::job
