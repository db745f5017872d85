// SPDX-License-Identifier: Apache-2.0
// How good the edges of a few scenes are: one of each kind of body and a plot. All of them take minutes:
// gallery_edges_nightly_test.cpp.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "gallery_edges.h"
#include "golden/suite_run.h"

namespace poinsot::render {
namespace {

namespace fs = std::filesystem;

class GalleryEdgesTest : public testing::TestWithParam<const char*> {
 protected:
  static void SetUpTestSuite() { gl::pinEnvironment(true); }
};

TEST_P(GalleryEdgesTest, AreGoodInItsPicture) {
  GalleryEdges edges(GetParam());
  EXPECT_LE(edges.worstMean(edges.still_s()), edges.limit());
}

INSTANTIATE_TEST_SUITE_P(Of, GalleryEdgesTest, testing::Values("chandler_wobble", "poinsot_rolling", "t_handle"),
                         [](const auto& scene) { return std::string(scene.param); });

// The measure is one: edges twice as soft, which no limit on single pixels would mind, are beyond it.
TEST_F(GalleryEdgesTest, SoftEdgesAreNot) {
  const ScratchFolder folder;
  const std::string shaders = (folder / "shaders").string();
  fs::copy(POINSOT_SOURCE_DIR "/shaders", shaders);
  const std::string text =
      textWith({"SoftEdges", "coverage.glsl", "edge.z * sharpness", "edge.z * 0.5 * sharpness"}, shaders);
  std::ofstream(fs::path(shaders) / "coverage.glsl") << text;
  setenv("POINSOT_SHADERS", shaders.c_str(), 1);
  GalleryEdges edges("chandler_wobble");
  const double worst = edges.worstMean(edges.still_s());
  unsetenv("POINSOT_SHADERS");  // programs are made when they are first drawn with
  EXPECT_GT(worst, GalleryEdges::kMost);
}

}  // namespace
}  // namespace poinsot::render
