// SPDX-License-Identifier: Apache-2.0
#include "preview/picture_press.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "core/error.h"
#include "image/png_file.h"
#include "job/frames_cache.h"
#include "request/requested_scene.h"

namespace poinsot::preview {
namespace {

request::RequestedScene sceneFor(const SceneVersion& version, const PictureAsk& ask) {
  request::SceneRequest request = version.request;
  request.overrides.insert(request.overrides.end(), ask.changes.overrides.begin(), ask.changes.overrides.end());
  request.size = ask.size;
  request.view = ask.changes.view;
  return request::requestedScene(std::move(request));
}

/// Returns a text that identifies the scene and size of a request, but not the version of the files.
std::string keyOf(const PictureAsk& ask) {
  std::string key = fmt::format("{}x{}", ask.size.width, ask.size.height);
  if (ask.changes.view) key += fmt::format(" view {}", *ask.changes.view);
  for (const std::string& word : ask.changes.overrides) key += fmt::format(" {}:{}", word.size(), word);
  return key;
}

}  // namespace

/// Cache of drawn scenes, used on the drawing thread. If OpenGL cannot be opened, each picture reports the error.
class PicturePress::Drawer {
 public:
  explicit Drawer(gl::Backend backend) : cache_(backend) {}

  std::string png(const SceneVersion& version, const PictureAsk& ask) {
    if (!version.scene) throw core::sceneError(version.error);
    if (version.number != version_) cache_.clear();
    version_ = version.number;
    auto& scene = cache_.of(keyOf(ask), [&] { return sceneFor(version, ask); }, {});
    const std::int64_t k = std::clamp<std::int64_t>(ask.frame, 0, scene.count - 1);
    const auto& picture = scene.frames->frame(k).picture;
    const auto bytes = std::visit([](const auto& image) { return image::encodePng(image); }, picture);
    return {bytes.begin(), bytes.end()};
  }

 private:
  job::FramesCache cache_;
  int version_ = 0;
};

PicturePress::PicturePress(const WatchedScene& scene, gl::Backend backend)
    : scene_(scene), drawer_([backend] { return std::make_unique<Drawer>(backend); }) {}

PicturePress::~PicturePress() = default;

std::string PicturePress::png(const PictureAsk& ask) {
  return drawer_.with([&, version = scene_.now()](Drawer& drawer) { return drawer.png(version, ask); });
}

}  // namespace poinsot::preview
