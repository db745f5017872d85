// SPDX-License-Identifier: Apache-2.0
#include "pictures.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <mutex>
#include <variant>

#include "app/frames_cache.h"
#include "app/owning_thread.h"
#include "core/error.h"
#include "gl/offscreen_context.h"
#include "image/png_file.h"

namespace poinsot::python {
namespace {

using Artist = app::OwningThread<app::FramesCache>;

/// Lives as long as the process: OpenGL has no business in the interpreter's end. A forked process, which has no
/// threads but the one that forked, gets its own.
Artist& artist() {
  static std::mutex one;
  const std::scoped_lock lock(one);
  static Artist* drawing = nullptr;
  static pid_t owner = 0;
  if (owner != getpid()) {
    gl::pinEnvironment(false);
    drawing = new Artist([] { return std::make_unique<app::FramesCache>(gl::Backend::kAuto); });
    owner = getpid();
  }
  return *drawing;
}

[[noreturn]] void refuse(const std::string& message) { throw core::Error(core::ErrorKind::kUsage, message); }

double timeOf(const scene::Scene& scene, const PictureAsk& ask) {
  const double time_s = ask.time_s.value_or(scene.time.stillTime_s());
  if (!(time_s >= 0 && time_s <= scene.time.duration_s))
    refuse(fmt::format("t = {} s: the film lasts from 0 to {} s", time_s, scene.time.duration_s));
  return time_s;
}

image::PixelSize sizeOf(const LoadedScene& loaded, const PictureAsk& ask) {
  const scene::Output& output = loaded.scene().output;
  const image::PixelSize size = ask.size.value_or(image::PixelSize{output.width, output.height});
  const std::int64_t most = loaded.limits()[scene::Limit::kSide];
  if (std::min(size.width, size.height) < scene::kLeastSide || std::max(size.width, size.height) > most)
    refuse(
        fmt::format("size {}x{}: sides from {} to {} pixels", size.width, size.height, scene::kLeastSide, most));
  return size;
}

/// Calls `use` with the picture, on the thread that drew it.
template <class Use>
auto withPicture(const LoadedScene& loaded, const PictureAsk& ask, const Use& use) {
  const double time_s = timeOf(loaded.scene(), ask);
  const image::PixelSize size = sizeOf(loaded, ask);
  if (ask.bits != 8 && ask.bits != 16) refuse(fmt::format("bits = {}: 8 or 16", ask.bits));
  const std::string key =
      fmt::format("{} {}x{} {} {}", loaded.number(), size.width, size.height, ask.transparent, ask.bits);
  const auto load = [&] {
    scene::Scene scene = loaded.scene();
    scene.output.width = size.width;
    scene.output.height = size.height;
    return scene;
  };
  return artist().with([&](app::FramesCache& cache) {
    app::SceneFrames& frames =
        *cache.of(key, load, {std::nullopt, ask.transparent, ask.bits}, loaded.limits()).frames;
    frames.setTime(time_s);
    return use(frames.frame(0).picture);
  });
}

}  // namespace

image::AnyImage pictureOf(const LoadedScene& scene, const PictureAsk& ask) {
  return withPicture(scene, ask, [](const image::AnyImage& picture) { return picture; });
}

std::vector<std::uint8_t> pngOf(const LoadedScene& scene, const PictureAsk& ask) {
  return withPicture(scene, ask, [](const image::AnyImage& picture) {
    return std::visit([](const auto& image) { return image::encodePng(image); }, picture);
  });
}

}  // namespace poinsot::python
