// SPDX-License-Identifier: Apache-2.0
// A cropped picture shows each point where the whole picture shows it, less the corner of the rectangle.
#include "draw/crop.h"

#include <gtest/gtest.h>

namespace poinsot::draw {
namespace {

Text textAt(glm::vec2 baseline_px) {
  Text text;
  text.baseline_px = baseline_px;
  return text;
}

Picture twoPanels() {
  Picture picture;
  picture.size_px = {300, 100};
  for (const int left : {0, 200}) {
    Panel panel;
    panel.origin_px = {left, 0};
    panel.list.camera =
        lookAt({5, 1, 2}, {0, 0, 0}, {0, 0, 1}, 1.0f, left == 0 ? glm::vec2(200, 100) : glm::vec2(100, 100));
    panel.list.texts.push_back(textAt({20, 30}));
    picture.panels.push_back(panel);
  }
  picture.strokes.push_back({{{10, 20}, {290, 90}}});
  picture.areas.push_back({{{10, 20}, {290, 90}, {0, 90}}});
  picture.texts.push_back(textAt({150, 60}));
  return picture;
}

TEST(Crop, KeepsThePlacesOfAllPoints) {
  const glm::ivec2 corner(30, 20), size(200, 70);
  for (const bool orthographic : {false, true}) {
    Picture whole = twoPanels();
    for (Panel& panel : whole.panels) panel.list.camera.orthographic = orthographic;
    const Picture part = cropped(whole, corner, size);
    ASSERT_EQ(part.panels.size(), 2u);
    EXPECT_EQ(part.size_px, size);
    for (std::size_t i = 0; i < 2; ++i)
      for (const glm::vec3 point : {glm::vec3(0), glm::vec3(0.3f, -0.5f, 0.7f), glm::vec3(-1, 0.2f, 0)}) {
        const auto at = [&](const Picture& picture) {
          const Panel& panel = picture.panels[i];
          return glm::vec2(panel.origin_px) + project(panel.list.camera, point);
        };
        EXPECT_NEAR(at(part).x, at(whole).x - 30, 1e-4);  // measured 8e-6
        EXPECT_NEAR(at(part).y, at(whole).y - 20, 1e-4);
      }
    EXPECT_EQ(part.strokes[0].points_px[1], glm::vec2(260, 70));
    EXPECT_EQ(part.areas[0].points_px[0], glm::vec2(-20, 0));
    EXPECT_EQ(part.texts[0].baseline_px, glm::vec2(120, 40));
    EXPECT_EQ(glm::vec2(part.panels[0].origin_px) + part.panels[0].list.texts[0].baseline_px, glm::vec2(-10, 10));
    EXPECT_EQ(part.panels[1].list.camera.size_px, glm::vec2(30, 70));
  }
}

TEST(Crop, LeavesOutPanelsBesideTheRectangle) {
  const Picture part = cropped(twoPanels(), {0, 0}, {200, 100});
  ASSERT_EQ(part.panels.size(), 1u);
  EXPECT_EQ(part.panels[0].list.camera.centre_px, twoPanels().panels[0].list.camera.centre_px);
}

}  // namespace
}  // namespace poinsot::draw
