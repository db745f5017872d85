// SPDX-License-Identifier: Apache-2.0
#include "pictures.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <variant>

#include "app/frames_cache.h"
#include "app/owning_thread.h"
#include "core/error.h"
#include "gl/offscreen_context.h"
#include "image/png_file.h"

namespace poinsot::python {
namespace {

using Artist = app::OwningThread<app::FramesCache>;

[[noreturn]] void refuse(const std::string& message) { throw core::Error(core::ErrorKind::kUsage, message); }

/// A process forked from one that draws has OpenGL's locks but none of its threads: it would wait for ever.
void refuseFork() {
  static const pid_t owner = getpid();
  if (owner != getpid())
    refuse(
        "this process is a fork of one that has drawn pictures, and cannot draw; start it with the method "
        "\"spawn\": multiprocessing.get_context(\"spawn\")");
}

/// Lives as long as the process: OpenGL has no business in the interpreter's end.
Artist& artist() {
  refuseFork();
  static Artist& drawing = *[] {
    gl::pinEnvironment(false);
    return new Artist([] { return std::make_unique<app::FramesCache>(gl::Backend::kAuto); });
  }();
  return drawing;
}

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
    return app::drawableOf(std::move(scene));
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
