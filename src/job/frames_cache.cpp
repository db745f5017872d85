// SPDX-License-Identifier: Apache-2.0
#include "job/frames_cache.h"

#include <algorithm>
#include <utility>

#include "core/frame_clock.h"
#include "request/memory.h"
#include "stage/stage.h"

namespace poinsot::job {
namespace {

// Who turns the camera asks for another scene each time, who plays for the same: a few, for a few who ask.
constexpr std::size_t kMost = 4;

}  // namespace

Drawable drawableOf(scene::Scene scene) {
  auto composer = std::make_unique<const stage::Stage>(scene);
  return {std::move(scene), std::move(composer)};
}

FramesCache::Entry& FramesCache::of(const std::string& key, const std::function<Drawable()>& load,
                                    const request::PictureForm& form, const scene::Limits& limits) {
  if (const auto found = std::ranges::find(entries_, key, &Entry::key); found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
    return entries_.front();
  }
  Drawable loaded = load();
  const scene::Scene& scene = loaded.scene;
  const image::PixelSize size{scene.output.width, scene.output.height};
  request::expectWithinMemory(request::workerMemory_bytes(size, {}, form.bits) + request::meshMemory_bytes(scene),
                              request::pictureText(size), limits);
  while (entries_.size() >= kMost) entries_.pop_back();
  if (!context_) context_ = gl::openContext(backend_);
  entries_.push_front(
      {key, core::frameCount(scene.time.duration_s, scene.time.fps),
       std::make_unique<SceneFrames>(scene, std::move(loaded.composer), *context_, std::nullopt, form)});
  return entries_.front();
}

}  // namespace poinsot::job
