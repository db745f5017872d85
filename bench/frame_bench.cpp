// SPDX-License-Identifier: Apache-2.0
// Benchmarks of the parts of one 1920x1080 frame of the tennis racket: CPU time on one core.
#include <benchmark/benchmark.h>

#include <cmath>

#include "image/png_file.h"
#include "output/yuv.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "stage/stage.h"

namespace poinsot {
namespace {

constexpr image::PixelSize kSize{1920, 1080};

const stage::Stage& racket() {
  static const stage::Stage stage(scene::loadScene(POINSOT_SOURCE_DIR "/scenes/tennis_racket.toml"));
  return stage;
}

draw::Picture racketAt(double time_s) {
  return racket().compose(std::fmod(time_s, racket().scene().time.duration_s), {kSize.width, kSize.height});
}

draw::DrawList racketList(double time_s) { return racketAt(time_s).panels.at(0).list; }

/// Returns the shared renderer, after it has drawn the first pictures, which compile shaders, outside any timing.
render::Renderer& renderer() {
  static const auto context = [] {
    gl::pinEnvironment(false);
    return gl::openContext(gl::Backend::kAuto);
  }();
  static render::Renderer renderer(*context);
  static const bool warm = [] {
    for (int k = 0; k < 60; ++k) renderer.render(racketList(0.2 * k), kSize);
    return true;
  }();
  benchmark::DoNotOptimize(warm);
  return renderer;
}

void compose(benchmark::State& state) {
  double t = 0;
  for (auto _ : state) benchmark::DoNotOptimize(racketAt(t += 0.033));
}
BENCHMARK(compose)->Unit(benchmark::kMillisecond);

void render(benchmark::State& state) {
  render::Renderer& warm = renderer();
  double t = 0;
  for (auto _ : state) benchmark::DoNotOptimize(warm.render(racketList(t += 0.033), kSize));
}
BENCHMARK(render)->Unit(benchmark::kMillisecond);

void encodePng(benchmark::State& state) {
  const image::Image picture = renderer().render(racketList(5), kSize);
  for (auto _ : state) benchmark::DoNotOptimize(image::encodePng(picture));
}
BENCHMARK(encodePng)->Unit(benchmark::kMillisecond);

void convertToYuv(benchmark::State& state) {
  const image::Image picture = renderer().render(racketList(5), kSize);
  std::vector<std::uint8_t> y(1920 * 1080), u(y.size() / 4), v(y.size() / 4);
  const output::YuvPlanes planes{y.data(), u.data(), v.data(), 1920, 960, 960};
  for (auto _ : state) {
    output::convertToYuv420(picture, planes);
    benchmark::ClobberMemory();
  }
}
BENCHMARK(convertToYuv)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace poinsot
