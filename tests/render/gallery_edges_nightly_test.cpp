// SPDX-License-Identifier: Apache-2.0
// Checks the edges of every scene of the gallery at two film times, in pictures of the size of a film. For the
// measurements see bench/journal/2026-11.md.
#include <gtest/gtest.h>

#include "gallery_edges.h"
#include "support/gallery_scenes.h"

namespace poinsot::render {
namespace {

class GalleryEdgesNightly : public testing::TestWithParam<std::string> {
 protected:
  static void SetUpTestSuite() { gl::pinEnvironment(true); }
};

TEST_P(GalleryEdgesNightly, HaveSmallErrorsAtTwoTimes) {
  GalleryEdges edges(GetParam(), {1920, 1080});
  EXPECT_LE(edges.worstMean(edges.still_s()), GalleryEdges::kMost);
  EXPECT_LE(edges.worstMean(edges.late_s()), GalleryEdges::kMost);
}

INSTANTIATE_TEST_SUITE_P(Each, GalleryEdgesNightly, testing::ValuesIn(galleryNames()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace poinsot::render
