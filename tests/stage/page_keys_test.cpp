// SPDX-License-Identifier: Apache-2.0
// Keys that make a picture ready for its page or its hall: large type, fewer axes, names of cones, no captions in
// figures, a shifted or enlarged picture, marks on the body.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "scene_samples.h"
#include "stage/type/lettering.h"
#include "support/gallery_scenes.h"

namespace poinsot::stage {
namespace {

using testing::Contains;
using testing::Not;

constexpr glm::ivec2 kSize{1920, 1080};
const std::string kTop = "[body]\nprincipal_moments = [2, 2, 0.8]\n[motion]\nomega_body = [1.1, 0.3, 2]\n";

draw::Picture hallPicture(const scene::Scene& scene) {
  return Stage(scene).compose(scene.time.stillTime_s(), kSize, styled(screenSizing(kSize), scene.style, kSize));
}

draw::Picture pictureOf(const std::string& text, const std::string& more = "") {
  return Stage(scene::parseScene(text + more, "a.toml")).compose(1, kSize);
}

std::vector<std::string> labelsOf(const draw::Picture& picture) {
  std::vector<std::string> all;
  for (const draw::Text& text : picture.panels.at(0).list.texts) all.push_back(text.tex);
  return all;
}

float smallestType_px(const draw::Picture& picture) {
  float smallest = 1e9f;
  for (const draw::Text& text : picture.texts) smallest = std::min(smallest, text.size_px);
  for (const draw::Panel& panel : picture.panels)
    for (const draw::Text& text : panel.list.texts) smallest = std::min(smallest, text.size_px);
  return smallest;
}

// In phase_portrait, the title of a plot is wider than its panel. It shrinks to fit, and the program notes this.
TEST(Hall, HasNoSmallTypeInAnyGalleryScene) {
  for (const std::string& name : galleryNames()) {
    if (name == "phase_portrait") continue;
    const scene::Scene scene = galleryScene(name, {"style.preset=\"hall\""});
    EXPECT_GE(smallestType_px(hallPicture(scene)), 0.033f * 1080 - 0.01f) << name;
  }
}

TEST(Hall, HasThickerLinesAndIsShortForThePreset) {
  const scene::Scene screen = scene::parseScene(kTop, "a.toml");
  const scene::Scene hall = scene::parseScene("style = \"hall\"\n" + kTop, "a.toml");
  EXPECT_EQ(hall.style.preset, scene::StylePreset::kHall);
  EXPECT_GE(hall.style.lineWidth, 1.5 * screen.style.lineWidth);
}

TEST(Hall, DoesNotApplyToPaper) {
  const scene::Scene hall = scene::parseScene("style = \"hall\"\n" + kTop, "a.toml");
  EXPECT_EQ(styled(printSizing(600), hall.style, kSize).least_px, printSizing(600).least_px);
}

TEST(PrincipalAxes, AreDrawnByNumber) {
  const auto all = labelsOf(pictureOf(kTop)),
             two = labelsOf(pictureOf(kTop, "[show]\nprincipal_axes.axes = [1, 3]\n"));
  EXPECT_THAT(all, Contains("$\\hat{\\mathbf{e}}_2$"));
  EXPECT_THAT(two, Not(Contains("$\\hat{\\mathbf{e}}_2$")));
  EXPECT_THAT(two, Contains("$\\hat{\\mathbf{e}}_1$"));
  EXPECT_THAT(two, Contains("$\\hat{\\mathbf{e}}_3$"));
  const auto cones = [](const draw::Picture& picture) { return picture.panels.at(0).list.frustums.size(); };
  const std::string three = "[show]\nprincipal_axes.axes = [1, 2, 3]\n",
                    one = "[show]\nprincipal_axes.axes = [2]\n";
  EXPECT_LT(cones(pictureOf(kTop, one)), cones(pictureOf(kTop, three)));
}

TEST(Cones, HaveNamesOnRequest) {
  const std::string shown = "[show]\ncones = true\n[label]\nspace_cone = 'space cone'\nbody_cone = 'body cone'\n";
  EXPECT_THAT(labelsOf(pictureOf(kTop, shown)), testing::IsSupersetOf({"space cone", "body cone"}));
}

TEST(CaptionsOfFigures, AreLeftOutUnlessAskedFor) {
  const std::string caption = "[[timeline]]\nat = 0\ncaption = 'Caption'\n";
  const auto textsOf = [&](const std::string& more, const Sizing& sizing) {
    std::vector<std::string> all;
    const Stage stage(scene::parseScene(kTop + more + caption, "a.toml"));
    for (const draw::Text& text : stage.compose(1, kSize, sizing).texts) all.push_back(text.tex);
    return all;
  };
  const std::string yes = "[show]\ncaptions = true\n", no = "[show]\ncaptions = false\n";
  EXPECT_THAT(textsOf("", screenSizing(kSize)), Contains("Caption"));
  EXPECT_THAT(textsOf("", printSizing(600)), Not(Contains("Caption")));
  EXPECT_THAT(textsOf(yes, printSizing(600)), Contains("Caption"));
  EXPECT_THAT(textsOf(no, screenSizing(kSize)), Not(Contains("Caption")));
}

TEST(CameraShift, MovesThePictureByFractionsOfItsSize) {
  const auto centre_px = [](const draw::Picture& picture) { return picture.panels.at(0).list.camera.centre_px; };
  const glm::vec2 by_px =
      centre_px(pictureOf(kTop, "[camera]\nshift = [0.1, 0.2]\n")) - centre_px(pictureOf(kTop));
  EXPECT_NEAR(by_px.x, 192, 1e-3);
  EXPECT_NEAR(by_px.y, -216, 1e-3);
}

TEST(CutOff, IsKnownForAZoomAndAShiftThatLeaveOutAPart) {
  const auto isCutOff = [](const std::string& camera) {
    return pictureOf(kTop, camera).panels.at(0).list.isCutOff;
  };
  EXPECT_FALSE(isCutOff(""));
  EXPECT_TRUE(isCutOff("[camera]\nzoom = 3\n"));
  EXPECT_FALSE(isCutOff("[camera]\nzoom = 0.5\nshift = [0.1, 0]\n"));
  EXPECT_TRUE(isCutOff("[camera]\nshift = [0, 0.4]\n"));
}

TEST(Marks, AreDrawnInTheirOwnColors) {
  const std::string box =
      "[body]\nshape = \"box\"\nsize = [0.3, 0.2, 0.1]\nmass = 1\n[motion]\nomega_body = [0.1, 3, 0]\n";
  const std::string mark =
      "[[mark]]\nshape = \"cylinder\"\nradius = \"1 cm\"\nheight = \"2 mm\"\noffset = [0, 0, \"5 cm\"]\n"
      "color = \"#CC0000\"\n";
  const auto plain = pictureOf(box), marked = pictureOf(box, mark);
  const auto& before = plain.panels.at(0).list.frustums;
  const auto& after = marked.panels.at(0).list.frustums;
  ASSERT_EQ(after.size(), before.size() + 1);
  const draw::Color red = draw::fromSrgb(0xCC0000);
  EXPECT_TRUE(std::ranges::any_of(after, [&](const draw::Frustum& f) { return f.material.color.r == red.r; }));
  EXPECT_EQ(plain.panels.at(0).list.camera.eye_V, marked.panels.at(0).list.camera.eye_V);
}

TEST(Marks, HaveNoMass) {
  const std::string mark = "[[mark]]\nshape = \"cube\"\nedge = 0.1\noffset = [1, 0, 0]\n";
  const auto plain = scene::parseScene(kTop, "a.toml"), marked = scene::parseScene(kTop + mark, "a.toml");
  EXPECT_EQ(plain.body.axes.moments().values(), marked.body.axes.moments().values());
}

TEST(Marks, OfTheCatalogueAreOnlyOnItsOwnShape) {
  const std::string phone = "[body]\ncatalogue = \"phone\"\n[motion]\nomega_body = [3, 0.01, 0]\n";
  EXPECT_GE(scene::parseScene(phone, "a.toml").body.marks.size(), 2u);
  EXPECT_TRUE(scene::parseScene(phone + "[show]\nbody.shape = \"sphere\"\n", "a.toml").body.marks.empty());
}

}  // namespace
}  // namespace poinsot::stage
