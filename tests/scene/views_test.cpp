// SPDX-License-Identifier: Apache-2.0
// Panels of a picture: what a view inherits from the scene, its place, and errors.
#include <gmock/gmock.h>

#include <array>
#include <numbers>

#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180;
const std::string kTop = "[body]\nprincipal_moments = [2, 2, 3]\n[motion]\nomega_body = [0.5, 0, 1]\n";

Scene sceneWith(const std::string& extra, const std::vector<std::string>& overrides = {}) {
  return parseScene(kTop + extra, "test.toml", overrides);
}

std::string messagesWith(const std::string& extra) { return messagesOf(kTop + extra, {}); }

TEST(Views, DefaultToASingleView) {
  const Scene scene = sceneWith("[camera]\nzoom = 2\n[show]\nL = false\n");
  ASSERT_EQ(scene.views.size(), 1u);
  EXPECT_EQ(scene.views[0].camera.zoom, 2);
  EXPECT_FALSE(scene.views[0].show.L.visible);
  EXPECT_EQ(scene.views[0].title, "");
}

TEST(Views, InheritCameraAndShowOfTheScene) {
  const Scene scene = sceneWith(
      "[camera]\nzoom = 2\n[show]\nplane.opacity = 0.5\nheight = false\n[[view]]\n[[view]]\ntitle = \"B\"\n"
      "subtitle = \"b\"\ncamera = {zoom = 3, frame = \"body\"}\nshow.plane.grid = false\nshow.height = true\n");
  ASSERT_EQ(scene.views.size(), 2u);
  const View &first = scene.views[0], &second = scene.views[1];
  EXPECT_EQ(first.camera.zoom, 2);
  EXPECT_EQ(first.camera.frame, CameraFrame::kSpace);
  EXPECT_TRUE(first.show.plane.grid);
  EXPECT_FALSE(first.show.height.visible);
  EXPECT_EQ(second.title + second.subtitle, "Bb");
  EXPECT_EQ(second.camera.zoom, 3);
  EXPECT_EQ(second.camera.frame, CameraFrame::kBody);
  EXPECT_EQ(second.show.plane.opacity, 0.5);
  EXPECT_FALSE(second.show.plane.grid);
  EXPECT_TRUE(second.show.height.visible);
}

TEST(Views, MayBeOverridden) {
  EXPECT_EQ(sceneWith("[[view]]\n[[view]]\n", {"view[1].camera.zoom=4"}).views[1].camera.zoom, 4);
  EXPECT_EQ(sceneWith("", {"camera.frames=[\"body\", \"space\"]"}).views.size(), 2u);
}

TEST(Views, ArePlacedAtTheirCellOrRightOfTheLastView) {
  const Scene scene = sceneWith("[[view]]\nspan = [2, 1]\n[[view]]\n[[view]]\nat = [0, 1]\n[[view]]\n");
  const std::vector<std::array<int, 4>> expected = {{0, 0, 2, 1}, {2, 0, 1, 1}, {0, 1, 1, 1}, {1, 1, 1, 1}};
  ASSERT_EQ(scene.views.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const GridPlace& v = scene.views[i].place;
    EXPECT_EQ((std::array{v.column, v.row, v.columns, v.rows}), expected[i]) << i;
  }
}

TEST(Views, CameraFramesGiveViewsSideBySide) {
  const Scene scene = sceneWith("[camera]\nframes = [\"space\", \"body\", \"precession\"]\nzoom = 1.5\n");
  ASSERT_EQ(scene.views.size(), 3u);
  const char* titles[] = {"In space", "In the body", "With the precession"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(scene.views[i].camera.frame, static_cast<CameraFrame>(i));
    EXPECT_EQ(scene.views[i].camera.zoom, 1.5);
    EXPECT_EQ(scene.views[i].place.column, static_cast<int>(i));
    EXPECT_EQ(scene.views[i].title, titles[i]);
  }
  EXPECT_EQ(sceneWith("[camera]\nframes = [\"body\"]\n").views[0].title, "");
}

TEST(Views, TakeMissingKeysFromAPreset) {
  const Scene scene = sceneWith(
      "[camera]\npreset = \"front\"\nelevation = \"10 deg\"\n[[view]]\n[[view]]\ncamera.preset = "
      "\"top\"\n[[view]]\n"
      "camera = {preset = \"top\", azimuth = \"5 deg\"}\n");
  EXPECT_DOUBLE_EQ(scene.views[0].camera.azimuth_rad, -90 * kDegree);
  EXPECT_DOUBLE_EQ(scene.views[0].camera.elevation_rad, 10 * kDegree);
  EXPECT_DOUBLE_EQ(scene.views[1].camera.elevation_rad, 90 * kDegree);
  EXPECT_DOUBLE_EQ(scene.views[2].camera.azimuth_rad, 5 * kDegree);
}

TEST(Views, LookAcrossThePathOfAThrownBody) {
  const auto azimuth_deg = [](const std::string& velocity, const std::vector<std::string>& more = {}) {
    std::vector<std::string> overrides = more;
    overrides.push_back("motion.flight.velocity=" + velocity);
    return parseScene(kMinimal, "test.toml", overrides).camera.azimuth_rad * 180 / std::numbers::pi;
  };
  EXPECT_NEAR(azimuth_deg("[2, 0, 3]"), -70, 1e-12);
  EXPECT_NEAR(azimuth_deg("[0, 2, 3]"), 20, 1e-12);
  EXPECT_NEAR(azimuth_deg("[-2, 0, 3]"), 110, 1e-12);
  EXPECT_NEAR(azimuth_deg("[-1, -1, 3]"), -205, 1e-12);
  EXPECT_NEAR(azimuth_deg("[0, 0, 3]"), 22, 1e-12);  // straight up: the default azimuth
  EXPECT_NEAR(azimuth_deg("[2, 0, 3]", {"camera.azimuth=5 deg"}), 5, 1e-12);
  EXPECT_NEAR(azimuth_deg("[2, 0, 3]", {"camera.preset=side"}), 0, 1e-12);
}

TEST(Views, ShowTheConstructionOnlyIfLIsConstant) {
  const Scene scene = sceneWith("[[view]]\nshow.plane = false\n[[view]]\n[motion.drag]\nrate = 0.1\n");
  for (const View& view : scene.views) EXPECT_FALSE(view.show.plane.visible || view.show.ellipsoid.visible);
  EXPECT_THAT(messagesWith("[[view]]\n[[view]]\nshow.plane = true\n[motion.drag]\nrate = 0.1\n"),
              HasSubstr("view[1].show.plane.visible: under gravity, torque or drag L is not constant"));
}

TEST(Views, RejectOverlappingPanels) {
  EXPECT_EQ(messagesWith("[[view]]\n[[view]]\nat = [0, 0]\n"),
            "view[1].at: the panel at [0, 0] would overlap view[0]; give another at\n");
  EXPECT_EQ(messagesWith("[[view]]\nspan = [2, 2]\n[[view]]\nat = [1, 1]\n"),
            "view[1].at: the panel at [1, 1] would overlap view[0]; give another at\n");
  EXPECT_THAT(
      messagesWith("[[view]]\nspan = [8, 1]\n[[view]]\n"),
      HasSubstr("view[1].at: the panel at [8, 0] would extend beyond the grid, which has at most 8 columns"));
}

TEST(Views, RejectCameraFramesTogetherWithViews) {
  EXPECT_THAT(messagesWith("[camera]\nframes = [\"space\", \"body\"]\n[[view]]\n"),
              HasSubstr("camera.frames: each [[view]] has a camera.frame of its own"));
  EXPECT_THAT(messagesWith("[camera]\nframes = [\"space\", \"body\"]\nframe = \"body\"\n"),
              HasSubstr("camera.frame: cannot be combined with camera.frames"));
  EXPECT_THAT(messagesWith("[camera]\nframes = [\"space\", \"space\"]\n"),
              HasSubstr("camera.frames: each word may be given once, got \"space\" again"));
  EXPECT_THAT(messagesWith("[[view]]\nshow.title = \"A\"\n"), HasSubstr("view[0].show.title: unknown key"));
}

TEST(Views, PrecessionFrameNeedsAFreeSymmetricBody) {
  const std::string frame = "[camera]\nframe = \"precession\"\n";
  EXPECT_EQ(messagesWith(frame), "");
  EXPECT_THAT(messagesWith(frame + "[motion.drag]\nrate = 0.1\n"),
              HasSubstr("camera.frame: \"precession\" does not exist: only free motion precesses steadily"));
  const std::string uneven = "[body]\nprincipal_moments = [2, 2.5, 3]\n[motion]\nomega_body = [0.5, 0, 1]\n";
  EXPECT_THAT(
      messagesOf(uneven + frame, {}),
      HasSubstr("camera.frame: \"precession\" does not exist: only a symmetric body precesses steadily; all "
                "three moments differ here: (2, 2.5, 3) kg·m²"));
  EXPECT_THAT(messagesOf(uneven + "[[view]]\n[[view]]\ncamera.frame = \"precession\"\n", {}),
              HasSubstr("view[1].camera.frame: \"precession\" does not exist"));
  EXPECT_THAT(messagesOf(uneven + "[camera]\nframes = [\"space\", \"precession\"]\n", {}),
              HasSubstr("camera.frames: \"precession\" does not exist"));
}

TEST(Views, CheckHeadingsAsTex) {
  const TextCheck check = [](std::string_view text) { return std::string(text == "bad" ? "no TeX" : ""); };
  EXPECT_THROW(parseScene(kTop + "[[view]]\nsubtitle = \"bad\"\n", "test.toml", {}, check), core::Error);
}

}  // namespace
}  // namespace poinsot::scene
