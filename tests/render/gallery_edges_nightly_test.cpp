// SPDX-License-Identifier: Apache-2.0
// How good the edges of every scene of the gallery are, at two instants each. What was measured:
// docs/performance.md.
#include <gtest/gtest.h>

#include <algorithm>

#include "gallery_edges.h"
#include "support/gallery_scenes.h"

namespace poinsot::render {
namespace {

class GalleryEdgesNightly : public testing::TestWithParam<std::string> {
 protected:
  static void SetUpTestSuite() { gl::pinEnvironment(true); }
};

TEST_P(GalleryEdgesNightly, AreGood) {
  GalleryEdges edges(GetParam());
  const double worst = std::max(edges.worstMean(edges.still_s()), edges.worstMean(edges.late_s()));
  EXPECT_LE(worst, edges.limit());
  if (edges.limit() > GalleryEdges::kMost) {
    EXPECT_GT(worst, GalleryEdges::kMost) << "good by now: strike it from kKnown";
  }
}

INSTANTIATE_TEST_SUITE_P(Of, GalleryEdgesNightly, testing::ValuesIn(galleryNames()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace poinsot::render
