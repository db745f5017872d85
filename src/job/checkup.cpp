// SPDX-License-Identifier: Apache-2.0
#include "job/checkup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <utility>

#include "core/error.h"
#include "core/frame_clock.h"
#include "core/temporary_folder.h"
#include "core/text.h"
#include "gl/offscreen_context.h"
#include "gl/shader_cache.h"
#include "job/render_job.h"
#include "output/film_format.h"
#include "process/landlock.h"
#include "request/memory.h"
#include "request/requested_scene.h"

namespace poinsot::job {
namespace {

using State = Finding::State;

constexpr const char* kScene =
    "[body]\n"
    "shape = \"racket\"\n"
    "size = [0.68, 0.26, 0.02]\n"
    "mass = 0.33\n"
    "[motion]\n"
    "omega_body = [0.04, 4.2, 0.04]\n"
    "[time]\n"
    "duration = 1\n"
    "[output]\n"
    "size = [1280, 720]\n";

/// Runs `work` and returns its text as a good finding. If `work` throws a core::Error, returns the error's message
/// as a finding with state `failed`.
template <class Work>
Finding finding(const std::string& subject, State failed, const Work& work) {
  try {
    return {State::kGood, subject, work()};
  } catch (const core::Error& error) {
    return {failed, subject, error.message()};
  }
}

Finding machine() {
  const request::FreeMemory memory = request::freeMemory();
  const std::string free =
      std::isfinite(memory.machine_bytes) ? request::memoryText(memory.machine_bytes) : "an unknown amount";
  return {State::kGood, "machine",
          fmt::format("{} CPU{}, {} of free memory", availableCpus(), availableCpus() == 1 ? "" : "s", free)};
}

Finding shaderCache() {
  const std::filesystem::path folder = gl::shaderCacheFolder(false);
  if (!folder.empty()) return {State::kGood, "shader cache", core::printable(folder.string())};
  return {State::kAbsent, "shader cache",
          "none, so each process compiles its shaders again, which takes 0.5 to 3 s; set POINSOT_CACHE to a "
          "folder that only you can write to"};
}

/// Checks each codec once, in the first container format that supports the codec.
std::vector<Finding> films() {
  using enum output::FilmContainer;
  std::vector<Finding> found;
  for (const auto container : {kMp4, kMov, kWebm, kGif, kApng})
    for (const output::FilmCodec codec : output::codecsOf(container)) {
      const std::string subject = fmt::format("film {}", output::nameOf(codec));
      if (std::ranges::find(found, subject, &Finding::subject) != found.end()) continue;
      const State failed = codec == output::codecsOf(kMp4).front() ? State::kBad : State::kAbsent;
      found.push_back(finding(subject, failed, [&] {
        output::FilmFormat format{.container = container, .codec = codec};
        output::checkFormat(format, {640, 360}, {30, 1});
        return fmt::format("NAME.{}", output::nameOf(container));
      }));
    }
  return found;
}

Finding sandbox() {
  return finding("sandbox", State::kAbsent, [] {
    const process::Landlock landlock;
    return std::string("--untrusted works");
  });
}

std::vector<Finding> backends() {
  std::vector<Finding> found;
  bool any = false;
  for (const gl::BackendReport& report : gl::probeBackends()) {
    found.push_back(
        {report.works ? State::kGood : State::kAbsent, "OpenGL " + report.name, core::printable(report.detail)});
    any |= report.works;
  }
  for (Finding& backend : found)
    if (!any) backend.state = State::kBad;
  return found;
}

Finding film() {
  return finding("test film", State::kBad, [] {
    const core::TemporaryFolder folder;
    const auto scene = request::requestedScene({.fileName = "doctor.toml", .text = kScene});
    const scene::Time& time = scene.scene.time;
    const auto frames = request::selectFrames(core::frameCount(time.duration_s, time.fps), {});
    RenderRequest render = renderRequest(scene, request::parseTarget((folder.path() / "doctor.mp4").string()),
                                         frames, {.segmentFrames = 10});
    render.workers = availableCpus();
    RenderJob job(std::move(render), [](std::int64_t, std::int64_t, double) {});
    return fmt::format("one second of film at {}x{} in {:.1f} s", scene.size().width, scene.size().height,
                       job.run().wall_s);
  });
}

}  // namespace

std::vector<Finding> checkup() {
  gl::pinEnvironment(false);
  // Makes the film first: workers are forks, which must start before this process opens OpenGL.
  std::vector<Finding> all{machine(), shaderCache(), sandbox(), film()};
  for (auto& more : {films(), backends()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace poinsot::job
