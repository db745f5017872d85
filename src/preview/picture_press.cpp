// SPDX-License-Identifier: Apache-2.0
#include "preview/picture_press.h"

#include <algorithm>
#include <list>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "app/frame_clock.h"
#include "app/memory.h"
#include "app/scene_frames.h"
#include "core/error.h"
#include "image/png_file.h"

namespace poinsot::preview {
namespace {

/// A scene ready to draw, in the form that a page asked for.
struct Prepared {
  int version = 0;
  image::PixelSize size;
  std::vector<std::string> overrides;
  std::int64_t frames = 0;
  std::unique_ptr<app::SceneFrames> source;

  bool isOf(int number, const PictureAsk& ask) const {
    return version == number && size == ask.size && overrides == ask.overrides;
  }
};

// A page that turns the camera asks for another form each time, one that plays for the same: a few, for a few
// pages.
constexpr std::size_t kMostPrepared = 4;

}  // namespace

/// What the thread owns. A context that cannot be opened is told with each picture.
class PicturePress::Drawer {
 public:
  explicit Drawer(gl::Backend backend) : backend_(backend) {}

  std::string png(const SceneVersion& version, const PictureAsk& ask) {
    if (!version.scene) throw core::Error(core::ErrorKind::kScene, version.error);
    Prepared& prepared = preparedFor(version, ask);
    const std::int64_t k = std::clamp<std::int64_t>(ask.frame, 0, prepared.frames - 1);
    const auto& picture = prepared.source->frame(k).picture;
    const auto bytes = std::visit([](const auto& image) { return image::encodePng(image); }, picture);
    return {bytes.begin(), bytes.end()};
  }

 private:
  Prepared& preparedFor(const SceneVersion& version, const PictureAsk& ask) {
    const auto isIt = [&](const Prepared& p) { return p.isOf(version.number, ask); };
    if (const auto found = std::ranges::find_if(prepared_, isIt); found != prepared_.end()) {
      prepared_.splice(prepared_.begin(), prepared_, found);
      return prepared_.front();
    }
    prepared_.remove_if([&](const Prepared& p) { return p.version != version.number; });
    while (prepared_.size() >= kMostPrepared) prepared_.pop_back();
    prepared_.push_front(prepare(version, ask));
    return prepared_.front();
  }

  Prepared prepare(const SceneVersion& version, const PictureAsk& ask) {
    app::SceneRequest request = version.request;
    request.overrides.insert(request.overrides.end(), ask.overrides.begin(), ask.overrides.end());
    request.size = ask.size;
    const scene::Scene scene = app::loadRequested(request);
    app::expectWithinMemory(app::workerMemory_bytes(ask.size, {}) + app::meshMemory_bytes(scene),
                            app::pictureText(ask.size), request.allowance.limits);
    if (!context_) context_ = gl::openContext(backend_);
    return {version.number, ask.size, ask.overrides, app::frameCount(scene.time.duration_s, scene.time.fps),
            std::make_unique<app::SceneFrames>(scene, *context_, std::nullopt)};
  }

  gl::Backend backend_;
  std::unique_ptr<gl::OffscreenContext> context_;
  std::list<Prepared> prepared_;  // the latest first; gone before the context
};

PicturePress::PicturePress(const WatchedScene& scene, gl::Backend backend)
    : scene_(scene), thread_([this, backend](const std::stop_token& stop) { work(stop, backend); }) {}

PicturePress::~PicturePress() = default;

std::string PicturePress::png(const PictureAsk& ask) {
  Job job([version = scene_.now(), ask](Drawer& drawer) { return drawer.png(version, ask); });
  std::future<std::string> picture = job.get_future();
  {
    const std::scoped_lock lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  waiting_.notify_one();
  return picture.get();
}

void PicturePress::work(const std::stop_token& stop, gl::Backend backend) {
  Drawer drawer(backend);
  while (true) {
    std::unique_lock lock(mutex_);
    if (!waiting_.wait(lock, stop, [&] { return !jobs_.empty(); })) break;
    Job job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    job(drawer);
  }
}

}  // namespace poinsot::preview
