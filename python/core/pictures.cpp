// SPDX-License-Identifier: Apache-2.0
#include "pictures.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <variant>

#include "core/error.h"
#include "core/owning_thread.h"
#include "gl/offscreen_context.h"
#include "image/png_file.h"
#include "job/frames_cache.h"
#include "signals.h"

namespace poinsot::python {
namespace {

using Artist = core::OwningThread<job::FramesCache>;

/// Exception that ends a picture whose caller has left.
class Abandoned : public std::exception {};

std::atomic<pid_t> owner = 0;  // process that draws; 0 before the first picture

/// Throws in a fork of a process that draws. The fork has OpenGL's locks but none of its threads, and would wait
/// forever.
void refuseFork() {
  pid_t expected = 0;
  if (owner.compare_exchange_strong(expected, getpid()) || expected == getpid()) return;
  throw core::usageError(
      "this process is a fork of one that has drawn pictures, and cannot draw; start it with the method "
      "\"spawn\": multiprocessing.get_context(\"spawn\")");
}

/// Returns the thread that draws. It lives as long as the process, because OpenGL must not end with the
/// interpreter.
Artist& artist() {
  refuseFork();
  static Artist& drawing = *[] {
    gl::pinEnvironment(false);
    return new Artist([] { return std::make_unique<job::FramesCache>(gl::Backend::kAuto); });
  }();
  return drawing;
}

/// Waits for a result, and abandons it if a signal's handler raises an exception.
template <class Result>
Result awaited(std::future<Result> result, std::atomic<bool>& abandoned) {
  try {
    while (result.wait_for(kPatience) != std::future_status::ready) checkSignals();
  } catch (...) {
    abandoned = true;
    throw;
  }
  return result.get();
}

/// Calls `use` with the picture, on the thread that drew it.
template <class Use>
auto withPicture(const std::shared_ptr<LoadedScene>& loaded, const PictureAsk& ask, const Use& use) {
  const request::PictureOptions form{std::nullopt, ask.transparent, ask.bits};
  const auto abandoned = std::make_shared<std::atomic<bool>>(false);
  auto drawn = artist().begin([=](job::FramesCache& cache) {
    const auto check = [&] {
      if (*abandoned) throw Abandoned();
    };
    check();
    const core::InterruptionCheck whileIntegrating(check);
    const auto load = [&] {
      request::RequestedScene requested = loaded->requested();
      requested.resize(ask.size);
      return requested;
    };
    const std::string key = fmt::format("{} {}x{} {} {}", loaded->number(), ask.size.width, ask.size.height,
                                        form.transparent, form.bits);
    job::SceneFrames& frames = *cache.of(key, load, form).frames;
    frames.setTime(ask.time_s);
    return use(frames.frame(0).picture);
  });
  return awaited(std::move(drawn), *abandoned);
}

}  // namespace

void requireSides(std::int64_t width, std::int64_t height, const scene::Limits& limits) {
  const std::int64_t most = limits[scene::Limit::kSide];
  const auto text = [&] {
    return fmt::format("size=({}, {}): sides must be from {} to {} pixels", width, height, scene::kLeastSide,
                       most);
  };
  if (std::min(width, height) < scene::kLeastSide) throw core::usageError(text());
  if (std::max(width, height) > most) throw core::limitError(text() + "; " + howToRaise(scene::Limit::kSide));
}

image::AnyImage pictureOf(const std::shared_ptr<LoadedScene>& scene, const PictureAsk& ask) {
  return withPicture(scene, ask, [](const image::AnyImage& picture) { return picture; });
}

std::vector<std::uint8_t> pngOf(const std::shared_ptr<LoadedScene>& scene, const PictureAsk& ask) {
  return withPicture(scene, ask, [](const image::AnyImage& picture) {
    return std::visit([](const auto& image) { return image::encodePng(image); }, picture);
  });
}

void finishPictures() {
  if (owner == getpid()) artist().begin([](job::FramesCache&) {}).wait();
}

}  // namespace poinsot::python
