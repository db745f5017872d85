// SPDX-License-Identifier: Apache-2.0
// Expected pixels are worked by hand. The camera is at distance 5 in front of the origin. Half of its picture's
// height of 100 pixels has the tangent 0.5, so a length of 1 at distance 1 is 100 pixels, and at the origin 20.
#include "figure/named_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace poinsot::figure {
namespace {

using testing::ElementsAre;

draw::Panel panel(glm::ivec2 origin_px, std::vector<draw::NamedPoint> points) {
  draw::Panel panel;
  panel.origin_px = origin_px;
  panel.list.camera = draw::lookAt({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 2 * std::atan(0.5f), {200, 100});
  panel.list.points = std::move(points);
  return panel;
}

draw::Picture pictureOf(std::vector<draw::Panel> panels) {
  draw::Picture picture;
  picture.size_px = {600, 400};
  picture.panels = std::move(panels);
  return picture;
}

std::vector<std::string> namesOf(const draw::Picture& picture, double pointsPerPixel = 0.5) {
  std::vector<std::string> names;
  for (const PlacedPoint& point : placedPoints(picture, pointsPerPixel)) names.push_back(point.name);
  return names;
}

TEST(PlacedPoints, AreWhereTheCameraSeesThem) {
  const auto placed = placedPoints(
      pictureOf({panel({30, 10}, {{"centre", {0, 0, 0}}, {"L", {1, 0.5f, 0}}, {"k", {1, 0, 4}}})}), 0.5);
  ASSERT_EQ(placed.size(), 3u);
  const glm::dvec2 expected[] = {{30 + 100, 10 + 50}, {30 + 100 + 20, 10 + 50 - 10}, {30 + 100 + 100, 10 + 50}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(placed[i].at_px.x, expected[i].x, 1e-3) << placed[i].name;
    EXPECT_NEAR(placed[i].at_px.y, expected[i].y, 1e-3) << placed[i].name;
  }
}

TEST(PlacedPoints, HaveTheNumberOfTheirPanel) {
  EXPECT_THAT(namesOf(pictureOf({panel({0, 0}, {{"L", {}}, {"x", {}}})})), ElementsAre("poinsot-L", "poinsot-x"));
  EXPECT_THAT(namesOf(pictureOf({panel({0, 0}, {{"L", {}}, {"x", {}}}), panel({200, 0}, {{"L", {}}})})),
              ElementsAre("poinsot-L", "poinsot-x", "poinsot-1-L", "poinsot-1-x", "poinsot-2-L"));
}

TEST(PlacedPoints, HaveNamesOfTheirOwn) {
  EXPECT_THAT(namesOf(pictureOf({panel({0, 0}, {{"v", {}}, {"v-2", {}}, {"v", {}}, {"v", {}}})})),
              ElementsAre("poinsot-v", "poinsot-v-2", "poinsot-v-3", "poinsot-v-4"));
}

// TeX stops with "Dimension too large" above 16383 pt.
TEST(PlacedPoints, LeaveOutPointsBehindTheCameraOrFarAway) {
  const auto picture = pictureOf({panel({0, 0}, {{"v", {0, 0, 6}}, {"v", {}}, {"far", {1000, 0, 0}}})});
  EXPECT_THAT(namesOf(picture), ElementsAre("poinsot-v-2"));                      // 20100 px are 10050 pt
  EXPECT_THAT(namesOf(picture, 0.1), ElementsAre("poinsot-v-2", "poinsot-far"));  // 2010 pt
}

}  // namespace
}  // namespace poinsot::figure
