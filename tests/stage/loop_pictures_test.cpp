// SPDX-License-Identifier: Apache-2.0
// In a film that repeats, the picture after the last equals the first, with its trails.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "scene_samples.h"

namespace poinsot::stage {
namespace {

constexpr glm::ivec2 kSize{960, 540};

float farthest(const draw::DrawList& a, const draw::DrawList& b) {
  EXPECT_EQ(a.curves.size(), b.curves.size());
  EXPECT_EQ(a.frustums.size(), b.frustums.size());
  float most = 0;
  for (std::size_t i = 0; i < std::min(a.frustums.size(), b.frustums.size()); ++i)
    most = std::max(most, glm::distance(a.frustums[i].to_V, b.frustums[i].to_V));
  for (std::size_t i = 0; i < std::min(a.curves.size(), b.curves.size()); ++i) {
    EXPECT_NEAR(static_cast<double>(a.curves[i].points_V.size()), static_cast<double>(b.curves[i].points_V.size()),
                2);
    most = std::max(most, glm::distance(a.curves[i].points_V.front(), b.curves[i].points_V.front()));
    most = std::max(most, glm::distance(a.curves[i].points_V.back(), b.curves[i].points_V.back()));
  }
  for (std::size_t i = 0; i < std::min(a.texts.size(), b.texts.size()); ++i)
    most = std::max(most, glm::distance(a.texts[i].baseline_px, b.texts[i].baseline_px) / 1000);
  return most;
}

TEST(LoopPictures, ThePictureAfterOneLoopEqualsTheFirst) {
  for (const char* show : {"", "[show.trace]\npoint = [0.3, 0.2, 0.1]\n", "[camera]\nframe = \"body\"\n"}) {
    const std::string time = "[time]\nduration = 6\n";
    const Stage stage(sample(time + "loop = true\n" + show)), plain(sample(time + show));
    const double whole = stage.scene().time.duration_s;
    EXPECT_LT(farthest(onlyList(stage, 0, kSize), onlyList(stage, whole, kSize)), 2e-5f) << show;
    const draw::DrawList again = stage.compose(1.3 + whole, kSize, screenSizing(kSize), {}).panels.at(0).list;
    EXPECT_LT(farthest(onlyList(stage, 1.3, kSize), again), 2e-5f) << show;
    EXPECT_FALSE(stage.scene().time.loop == std::nullopt);
  }
}

// The motion of a top is integrated, and must also cover the film before the first picture.
TEST(LoopPictures, RepeatThePathOfATop) {
  const Stage stage(scene::parseScene(
      "[body]\nprincipal_moments = [1, 1, 2]\n[motion]\nspin = 6\nspin_axis = \"3\"\nlean = 0.8\n"
      "precession = \"slow\"\ngravity.mgr_body = [0, 0, 4]\n[time]\nduration = 6\nloop = true\n[show]\n"
      "trace = true\n",
      "top.toml"));
  const double whole = stage.scene().time.duration_s;
  EXPECT_LT(farthest(onlyList(stage, 0, kSize), onlyList(stage, whole, kSize)), 2e-5f);
}

// The whole path has been travelled once before, so that nothing of it begins or ends at the first picture.
TEST(LoopPictures, PathsHaveNoVisibleStart) {
  const Stage stage(sample("[time]\nduration = 6\nloop = true\n"));
  std::vector<std::size_t> counts;
  for (const double t : {0.0, 0.1, 2.0, 5.0}) counts.push_back(onlyList(stage, t, kSize).curves.size());
  for (const std::size_t count : counts) EXPECT_EQ(count, counts.front());
}

TEST(LoopPictures, CurvesOfPlotsDoNotChange) {
  const Stage stage(sample("[time]\nduration = 6\nloop = true\n[[plot]]\nquantities = [\"omega_1\"]\n"));
  const auto strokes = [&](double t) { return stage.compose(t, kSize).strokes; };
  const auto longest = [](const std::vector<draw::Stroke>& all) {
    return std::ranges::max(all, {}, [](const draw::Stroke& s) { return s.points_px.size(); });
  };
  EXPECT_EQ(longest(strokes(0)).points_px, longest(strokes(3)).points_px);
  EXPECT_EQ(longest(strokes(0)).color, longest(strokes(3)).color);
}

}  // namespace
}  // namespace poinsot::stage
