// SPDX-License-Identifier: Apache-2.0
#include "job/frames_cache.h"

#include <algorithm>

#include "core/frame_clock.h"
#include "job/render_request.h"

namespace poinsot::job {
namespace {

// Number of cached scenes. Playback needs only one scene, but each camera movement in the preview creates a new
// scene. Four scenes are enough for a few users.
constexpr std::size_t kMostEntries = 4;

}  // namespace

FramesCache::Entry& FramesCache::of(const std::string& key, const std::function<request::RequestedScene()>& load,
                                    const request::PictureOptions& form) {
  if (const auto found = std::ranges::find(entries_, key, &Entry::key); found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
    return entries_.front();
  }
  const request::RequestedScene requested = load();
  const scene::Time& time = requested.scene.time;
  expectWithinMemory(renderRequest(requested, {request::OutputKind::kPicture, {}}, {}, {.form = form}));
  while (entries_.size() >= kMostEntries) entries_.pop_back();
  if (!context_) context_ = gl::openContext(backend_);
  entries_.push_front({key, core::frameCount(time.duration_s, time.fps),
                       std::make_unique<SceneFrames>(requested, form, *context_)});
  return entries_.front();
}

}  // namespace poinsot::job
