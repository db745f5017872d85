// SPDX-License-Identifier: Apache-2.0
// Builds a program with a sanitizer and draws on several threads. With the installed suppressions, the program
// ends with 0 and prints nothing (docs/library.md, "Sanitizers").
#include <gtest/gtest.h>

#include "package/installed_tree.h"
#include "support/sanitized.h"

namespace poinsot {
namespace {

const char* const kThreads = R"(
#include <thread>
#include <vector>
#include "gl/offscreen_context.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "stage/stage.h"
using namespace poinsot;
int main(int words, char**) {
  gl::pinEnvironment(false);
  const stage::Stage stage(scene::parseScene(
      "[body]\nprincipal_moments = [1, 2, 2.5]\n[motion]\nomega_body = [0.05, 3, 0.05]\n", "x.toml"));
  std::vector<image::Image> pictures(4);
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&, k] {
      const auto context = gl::openContext(k % 2 && words > 1 ? gl::Backend::kEgl : gl::Backend::kOsMesa);
      render::Renderer renderer(*context);
      for (int i = 0; i < 3; ++i) pictures[k] = renderer.render(stage.compose({2.5, true}, {320, 180}));
    });
  for (std::thread& thread : threads) thread.join();
  for (const image::Image& picture : pictures)
    if (picture != pictures[0]) return 2;
}
)";

/// Sanitizer and its options. EGL's driver is unloaded before the leak check, so no suppression could name its
/// leaks.
struct Sanitizer {
  const char *flag, *options, *run;
};

class Suppressions : public testing::TestWithParam<Sanitizer> {};

TEST_P(Suppressions, SilenceSanitizersWhileThreadsDraw) {
  POINSOT_NOT_SANITIZED("the program is built with one of its own");
  const InstalledTree tree;
  tree.folder().put("threads.cpp", kThreads);
  tree.run(std::string("$CXX -std=c++20 -g -fsanitize=") + GetParam().flag +
           " -o threads threads.cpp $(pkg-config --cflags --libs poinsot-stage poinsot-render)");
  for (int run = 0; run < 3; ++run)
    EXPECT_EQ(tree.run(std::string("POINSOT_CACHE=$PWD/cache ") + GetParam().options + GetParam().run), "");
}

INSTANTIATE_TEST_SUITE_P(
    Each, Suppressions,
    testing::Values(
        Sanitizer{"thread", "TSAN_OPTIONS=suppressions=$PREFIX/share/poinsot/tsan.supp", " ./threads egl 2>&1"},
        Sanitizer{"address", "LSAN_OPTIONS=print_suppressions=0:suppressions=$PREFIX/share/poinsot/lsan.supp",
                  " ./threads 2>&1"}),
    [](const auto& sanitizer) { return std::string(sanitizer.param.flag); });

}  // namespace
}  // namespace poinsot
