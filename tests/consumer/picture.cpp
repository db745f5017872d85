// SPDX-License-Identifier: Apache-2.0
// From the text of a scene to a PNG, in one process.
#include <cstdio>
#include <fstream>

#include "gl/offscreen_context.h"
#include "image/png_file.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "stage/stage.h"

int main(int argc, char** argv) try {
  if (argc != 2) return 2;
  const auto scene = poinsot::scene::parseScene(
      "[body]\nprincipal_moments = [1.0, 2.0, 2.5]\n[motion]\nomega_body = [0.05, 3.0, 0.0]\n", "spin.toml");
  poinsot::gl::pinEnvironment(false);
  const auto context = poinsot::gl::openContext(poinsot::gl::Backend::kAuto);
  poinsot::render::Renderer renderer(*context);
  const poinsot::stage::Stage stage(scene);
  const auto png = poinsot::image::encodePng(renderer.render(stage.compose(0.5, {320, 180})));
  std::ofstream file(argv[1], std::ios::binary);
  file.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  std::printf("drawn with %s\n", context->backendName());
  return file.flush() ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
