// SPDX-License-Identifier: Apache-2.0
// Prints a hash of the pixels of small pictures of scenes, as --reproducible draws them, for the test that no CPU
// changes one. The control: --unpinned, drawn as this CPU does it best. First of all, what the CPU is said to
// have.
#include <fmt/format.h>

#include <cstdio>
#include <span>
#include <string_view>

#include "core/sha256.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "stage/stage.h"

using namespace poinsot;

namespace {

constexpr image::PixelSize kSize{192, 108};

core::Digest hashOf(const image::Image& picture) {
  return core::sha256({reinterpret_cast<const char*>(picture.pixels.data()), picture.pixels.size()});
}

image::Image pictureOf(const char* scene, render::Renderer& renderer) {
  const stage::Stage stage(scene::loadScene(scene));
  return renderer.render(stage.compose(stage.scene().time.stillTime_s(), {kSize.width, kSize.height}));
}

}  // namespace

int main(int argc, char** argv) {
  std::span<char*> scenes(argv + 1, static_cast<std::size_t>(argc - 1));
  const bool pinned = scenes.empty() || scenes.front() != std::string_view("--unpinned");
  if (!pinned) scenes = scenes.subspan(1);
  gl::pinEnvironment(pinned);
  fmt::print("avx2={} fma={}\n", __builtin_cpu_supports("avx2") ? 1 : 0, __builtin_cpu_supports("fma") ? 1 : 0);
  const auto context = gl::openContext(gl::Backend::kAuto);
  render::Renderer renderer(*context);
  for (const char* scene : scenes) fmt::print("{}\n", core::toHex(hashOf(pictureOf(scene, renderer))));
  return 0;
}
