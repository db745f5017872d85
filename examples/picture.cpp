// SPDX-License-Identifier: Apache-2.0
// Draws a picture from the text of a scene, in one process: scene, stage, renderer, file.
#include <cstdio>

#include "core/error.h"
#include "gl/offscreen_context.h"
#include "output/png_sequence.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "stage/stage.h"

using namespace poinsot;

const char* const kScene = R"(
[body]
shape = "box"
size = ["24 cm", "17 cm", "3 cm"]
mass = 1

[motion]
omega_body = [0.05, 3, 0.05]

[show]
title = "A book, spun about its middle axis"
)";

int main(int argc, char** argv) try {
  if (argc != 2) return std::fprintf(stderr, "usage: picture NAME.png\n"), 2;
  const scene::Scene scene = scene::parseScene(kScene, "book.toml");  // the name appears in messages
  const stage::Stage stage(scene);                                    // computes the motion at any time

  gl::pinEnvironment(false);  // before any use of OpenGL
  const auto context = gl::openContext(gl::Backend::kAuto);
  render::Renderer renderer(*context);  // belongs to this thread, like the context

  const draw::Picture picture =
      stage.compose({2.5, true}, {640, 360});           // a still at 2.5 s, as values: no pixel is drawn yet
  output::writePng(argv[1], renderer.render(picture));  // appears only when complete
  std::printf("%s, drawn with %s\n", argv[1], context->backendName());
} catch (const core::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
