// SPDX-License-Identifier: Apache-2.0
// Pictures of several panels, checked as values: no GL, no pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "ink.h"
#include "scene_samples.h"

namespace poinsot::stage {
namespace {

using draw::DrawList;
using draw::Picture;
using glm::vec2;
using glm::vec3;

constexpr glm::ivec2 kSize{960, 540};
const double kTimes[] = {0, 0.7, 3.3, 5, 9.9};

// Returns a symmetric top that starts away from time 0, so that its axis is somewhere on its way round L.
scene::Scene top(const std::string& extra) {
  return scene::parseScene(
      "[body]\nshape = \"cylinder\"\nradius = 1\nheight = 3\nmass = 1\n[motion]\nomega_body = [0.6, 0.3, 2]\n"
      "[time]\nstart = 7\nspeed = 1\n[show]\nellipsoid = false\nplane = false\npolhode = false\nherpolhode = "
      "false\n" +
          extra,
      "top.toml");
}

const std::string kThree = "[camera]\nframes = [\"space\", \"body\", \"precession\"]\n";

const draw::Color kBlue = palette(scene::Theme::kLight).L, kVermilion = palette(scene::Theme::kLight).omega;

/// Returns the direction of an arrow's tip; the arrow is found by its colour.
vec3 arrow(const DrawList& list, const draw::Color& color) {
  for (const draw::Frustum& f : list.frustums)
    if (f.material.color == color && f.toRadius == 0) return glm::normalize(f.to_V);
  ADD_FAILURE() << "no such arrow";
  return vec3(0);
}

vec3 axisOf(const DrawList& list) { return glm::normalize(list.frustums.at(0).to_V - list.frustums.at(0).from_V); }

TEST(Views, EachFrameKeepsItsReferenceDirectionsFixed) {
  const Stage stage(top(kThree));
  const Picture start = stage.compose(0, kSize);
  ASSERT_EQ(start.panels.size(), 3u);
  for (const double t : kTimes) {
    const Picture now = stage.compose(t, kSize);
    const auto moved = [&](std::size_t panel, auto what) {
      return glm::distance(what(start.panels[panel].list), what(now.panels[panel].list));
    };
    const auto L = [](const DrawList& list) { return arrow(list, kBlue); };
    const auto omega = [](const DrawList& list) { return arrow(list, kVermilion); };
    // Measured at most 1.7e-7: floats.
    EXPECT_LT(moved(0, L), 1e-6f) << t;
    EXPECT_LT(moved(1, axisOf), 1e-6f) << t;
    EXPECT_LT(moved(2, L), 1e-6f) << t;
    EXPECT_LT(moved(2, axisOf), 1e-6f) << t;
    EXPECT_LT(moved(2, omega), 1e-6f) << t;
    if (t == 0) continue;
    EXPECT_GT(moved(0, axisOf), 1e-2f) << t;
    EXPECT_GT(moved(1, L), 1e-2f) << t;
  }
}

// In the precessing frame, the body turns about its axis at -Omega_p = (1 - I3/I1) omega_3 (lecture, eq 29). Here
// I1 = (3·1 + 9)/12 = 1, I3 = 1/2 and omega_3 = 2, which gives 1 rad/s.
TEST(Views, PrecessingFrameShowsTheBodyTurnAtMinusOmegaP) {
  const Stage stage(top(kThree));
  const auto e1 = [&](double t) {
    const DrawList list = stage.compose(t, kSize).panels.at(2).list;
    std::vector<vec3> tips;  // of the axes, in their order
    for (const draw::Frustum& f : list.frustums)
      if (f.toRadius == 0 && f.material.color != kBlue && f.material.color != kVermilion)
        tips.push_back(glm::normalize(f.to_V));
    return tips.at(0);
  };
  const DrawList list = stage.compose(0, kSize).panels.at(2).list;
  const vec3 from = e1(0), k = axisOf(list);
  for (const double t : {0.2, 1.0, 2.5}) {
    const vec3 to = e1(t);
    const float angle = std::atan2(glm::dot(glm::cross(from, to), k), glm::dot(from, to));
    EXPECT_NEAR(std::abs(angle), 1.0 * t, 2e-6) << t;  // measured 3e-7
  }
}

// All frames show the same angles between L, omega and the axis.
TEST(Views, ShowTheSameInstant) {
  const Stage stage(top(kThree));
  for (const double t : kTimes) {
    const Picture picture = stage.compose(t, kSize);
    const DrawList& space = picture.panels[0].list;
    for (const auto& panel : picture.panels) {
      const DrawList& list = panel.list;
      EXPECT_NEAR(glm::dot(arrow(list, kBlue), arrow(list, kVermilion)),
                  glm::dot(arrow(space, kBlue), arrow(space, kVermilion)), 1e-6);
      EXPECT_NEAR(glm::dot(arrow(list, kBlue), axisOf(list)), glm::dot(arrow(space, kBlue), axisOf(space)), 1e-6);
    }
  }
}

struct Rectangle {
  glm::ivec2 low, high;
};

std::vector<Rectangle> rectangles(const Picture& picture) {
  std::vector<Rectangle> all;
  for (const auto& panel : picture.panels)
    all.push_back({panel.origin_px, panel.origin_px + glm::ivec2(panel.list.camera.size_px)});
  return all;
}

bool overlap(const Rectangle& a, const Rectangle& b) {
  return glm::all(glm::lessThan(a.low, b.high)) && glm::all(glm::lessThan(b.low, a.high));
}

// No grid divides these sizes.
TEST(Views, FillThePictureBelowItsTitleWithoutOverlap) {
  const std::string grid =
      "[[view]]\nspan = [2, 1]\n[[view]]\nspan = [1, 2]\n[[view]]\nat = [0, 1]\n[[view]]\nat = [1, 1]\n";
  for (const std::string& title : {std::string(), std::string("title = \"A title\"\n")})
    for (const glm::ivec2 size : {glm::ivec2(961, 541), glm::ivec2(640, 1000), glm::ivec2(32, 18)}) {
      const Picture picture = Stage(top(title + grid)).compose(1, size);
      const auto panels = rectangles(picture);
      ASSERT_EQ(panels.size(), 4u);
      const int top_px = panels[0].low.y;
      int area = 0;
      for (std::size_t i = 0; i < panels.size(); ++i) {
        area += (panels[i].high.x - panels[i].low.x) * (panels[i].high.y - panels[i].low.y);
        for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(panels[i], panels[k])) << i << " " << k;
        EXPECT_TRUE(panels[i].high.x <= size.x && panels[i].high.y <= size.y) << i;
      }
      EXPECT_EQ(area, size.x * (size.y - top_px));
      EXPECT_EQ(top_px > 0, !title.empty());
    }
}

TEST(Views, LabelsStayInTheirPanelBelowItsHeading) {
  const Stage stage(
      top("[[view]]\ntitle = \"In space\"\nsubtitle = \"seen from afar\"\n[[view]]\ntitle = \"In the "
          "body\"\ncamera.frame = \"body\"\n"));
  for (double t = 0; t < 10; t += 0.5) {
    const Picture picture = stage.compose(t, kSize);
    for (std::size_t i = 0; i < picture.panels.size(); ++i) {
      const auto& panel = picture.panels[i];
      double heading = 0;  // lowest ink of the heading
      for (const draw::Text& text : picture.texts) {
        const PixelBox ink = inkOf(text);
        const bool here = ink.left >= panel.origin_px.x &&
                          ink.right <= panel.origin_px.x + static_cast<double>(panel.list.camera.size_px.x);
        if (here) heading = std::max(heading, ink.bottom);
      }
      EXPECT_GT(heading, 0);
      for (const draw::Text& text : panel.list.texts) {
        const PixelBox ink = inkOf(text);
        EXPECT_GE(ink.left, 0) << text.tex << " at " << t;
        EXPECT_GE(ink.top, heading) << text.tex << " at " << t;
        EXPECT_LE(ink.right, panel.list.camera.size_px.x) << text.tex << " at " << t;
        EXPECT_LE(ink.bottom, panel.list.camera.size_px.y) << text.tex << " at " << t;
      }
    }
  }
}

TEST(Views, HeadingsAreCentredOverTheirPanels) {
  const Picture picture = Stage(top(kThree)).compose(0, kSize);
  ASSERT_EQ(picture.texts.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const PixelBox ink = inkOf(picture.texts[i]);
    EXPECT_NEAR(0.5 * (ink.left + ink.right), 160.0 + 320.0 * static_cast<double>(i), 1.5)
        << i;  // side bearings: measured 0.5
  }
}

// Type in half the width is more than half as large, and the body is as large in both panels.
TEST(Views, KeepTextLegibleAndBodiesOfOneSize) {
  const auto largestType = [](const DrawList& list) {
    return std::ranges::max(list.texts, {}, &draw::Text::size_px).size_px;
  };
  const Picture two = Stage(top("[camera]\nframes = [\"space\", \"body\"]\n")).compose(0, kSize);
  const DrawList whole = onlyList(Stage(top("")), 0, kSize);
  for (const auto& panel : two.panels) EXPECT_GT(largestType(panel.list), 0.8f * largestType(whole));
  const auto unit_px = [](const DrawList& list) {
    return list.camera.focal_px() / depthOf(list.camera, vec3(0)) * glm::length(list.frustums[0].to_V);
  };
  EXPECT_NEAR(unit_px(two.panels[0].list) / unit_px(two.panels[1].list), 1, 1e-5);
}

TEST(Views, AreSeparatedByLines) {
  EXPECT_TRUE(Stage(top("")).compose(0, kSize).strokes.empty());
  const Picture picture = Stage(top(kThree)).compose(0, kSize);
  ASSERT_EQ(picture.strokes.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
    for (const vec2& p : picture.strokes[i].points_px) EXPECT_EQ(p.x, 320.0f * static_cast<float>(i + 1));
}

// In the smallest picture, panels may have no pixels; nothing may divide by their size.
TEST(Views, FitIntoTheSmallestPicture) {
  std::string grid = "title = \"A title\"\n";
  for (int i = 0; i < 8; ++i)
    grid += "[[view]]\nat = [" + std::to_string(i) + ", " + std::to_string(i) + "]\ntitle = \"A long heading\"\n";
  const Picture picture = Stage(top(grid)).compose(0, {16, 16});
  for (const auto& panel : picture.panels) {
    EXPECT_TRUE(std::isfinite(panel.list.camera.eye_V.x));
    EXPECT_LE(panel.origin_px.y + panel.list.camera.size_px.y, 16);
  }
}

// The layout follows technical drawings.
TEST(Views, TopPresetShowsXToTheRightAndYUp) {
  const draw::Camera camera = onlyList(Stage(top("[camera]\npreset = \"top\"\n")), 0, kSize).camera;
  const vec2 centre = project(camera, vec3(0));
  const vec2 x = project(camera, vec3(0.1f, 0, 0)) - centre, y = project(camera, vec3(0, 0.1f, 0)) - centre;
  EXPECT_GT(x.x, 1);
  EXPECT_NEAR(x.y, 0, 1e-3);
  EXPECT_LT(y.y, -1);
  EXPECT_NEAR(y.x, 0, 1e-3);
}

}  // namespace
}  // namespace poinsot::stage
