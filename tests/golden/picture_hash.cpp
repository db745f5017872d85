// SPDX-License-Identifier: Apache-2.0
// Prints hashes of the pixels of small pictures, as --reproducible draws them, and of their PNG files. A test
// checks that no CPU changes the hashes. As a control, --unpinned draws with all features of this CPU. The first
// line lists two features of the CPU.
#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/sha256.h"
#include "image/png_file.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "stage/stage.h"

using namespace poinsot;

namespace {

constexpr image::PixelSize kSize{192, 108};

std::string hashOf(const std::vector<std::uint8_t>& bytes) {
  return core::toHex(core::sha256({reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
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
  for (const char* scene : scenes) {
    const image::Image picture = pictureOf(scene, renderer);
    fmt::print("{} {}\n", hashOf(picture.pixels), hashOf(image::encodePng(picture)));
  }
  return 0;
}
