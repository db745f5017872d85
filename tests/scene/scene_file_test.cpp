// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <numbers>

#include "scene/limits.h"
#include "scene_testing.h"
#include "support/scratch_folder.h"

namespace poinsot::scene {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kOneDegree = kPi / 180;

// Defaults of a file with only a body and a start.
TEST(SceneFile, NeedsABodyAndAStartOnly) {
  const Scene scene = loadScene(dataPath("minimal.toml"));
  EXPECT_EQ(scene.name, "minimal");
  EXPECT_EQ(scene.body.axes.moments().values(), Eigen::Vector3d(1, 2, 2.5));
  EXPECT_TRUE(scene.body.parts.empty());
  EXPECT_FALSE(scene.body.mass || scene.body.pivot_B);
  EXPECT_TRUE(scene.motion.forcing.none());
  EXPECT_EQ(scene.motion.tolerance_rad, 1e-12);
  EXPECT_EQ(scene.motion.omega_B, Eigen::Vector3d(0.01, 3, 0));
  EXPECT_FALSE(scene.motion.orientation_WB);
  EXPECT_EQ(scene.motion.lPoints, LPoints::kAuto);
  EXPECT_EQ(scene.time.start_s, 0);
  EXPECT_EQ(scene.time.duration_s, 10);
  EXPECT_EQ(scene.time.fps, (core::Rational{30, 1}));
  EXPECT_FALSE(scene.time.speed);
  EXPECT_DOUBLE_EQ(scene.camera.azimuth_rad, 22 * kOneDegree);
  EXPECT_DOUBLE_EQ(scene.camera.elevation_rad, 18 * kOneDegree);
  EXPECT_DOUBLE_EQ(scene.camera.fov_rad, 24 * kOneDegree);
  EXPECT_EQ(scene.camera.zoom, 1);
  EXPECT_EQ(scene.camera.frame, CameraFrame::kSpace);
  EXPECT_EQ(scene.show.title + scene.show.subtitle, "");
  EXPECT_EQ(scene.show.exaggerateAngles, 1);
  EXPECT_TRUE(scene.show.labels && scene.show.body.visible && scene.show.plane.visible && scene.show.L.visible);
  EXPECT_EQ(scene.show.ellipsoid.opacity, 0.13);
  EXPECT_EQ(scene.show.plane.opacity, 0.16);
  EXPECT_EQ(scene.style.theme, Theme::kLight);
  EXPECT_EQ(scene.output.width, 1920);
  EXPECT_EQ(scene.output.height, 1080);
  EXPECT_EQ(scene.output.crf, 18);
}

// Every key of full.toml differs from its default, so that a key stored in the wrong member shows.
class FullScene : public testing::Test {
 protected:
  const Scene scene = loadScene(dataPath("full.toml"));
};

TEST_F(FullScene, ReadsBodyAndStart) {
  ASSERT_EQ(scene.body.parts.size(), 1u);
  const auto& racket = solidOf<physics::Racket>(scene.body.parts[0]);
  EXPECT_EQ(racket.length_m, 0.685);
  EXPECT_EQ(racket.width_m, 0.26);
  EXPECT_EQ(scene.body.parts[0].mass_kg, 0.33);
  EXPECT_EQ(scene.body.mass->mass_kg(), 0.33);
  // Hoop of radius 0.13 m and handle of 0.425 m, masses 17 : 16 of 0.33 kg: I_x = 0.17·0.13²/2, by hand.
  EXPECT_NEAR(scene.body.axes.moments()[0], 1.4365e-3, 1e-12);
  EXPECT_TRUE(scene.motion.omega_B.isApprox(Eigen::Vector3d(kPi / 300, 2 * kPi, -kPi / 2)));
  ASSERT_TRUE(scene.motion.orientation_WB);  // a quarter turn about z, normalised
  EXPECT_TRUE(
      scene.motion.orientation_WB->coeffs().isApprox(Eigen::Vector4d(0, 0, std::sqrt(0.5), std::sqrt(0.5))));
  EXPECT_EQ(scene.motion.lPoints, LPoints::kUp);
}

TEST_F(FullScene, ReadsTimeAndCamera) {
  EXPECT_EQ(scene.time.start_s, 7200);
  EXPECT_EQ(scene.time.duration_s, 12.5);
  EXPECT_EQ(scene.time.fps, (core::Rational{30000, 1001}));
  EXPECT_EQ(scene.time.speed, -0.5);
  EXPECT_DOUBLE_EQ(scene.camera.azimuth_rad, -120 * kOneDegree);
  EXPECT_EQ(scene.camera.elevation_rad, 0.5);
  EXPECT_DOUBLE_EQ(scene.camera.fov_rad, 40 * kOneDegree);
  EXPECT_EQ(scene.camera.zoom, 1.25);
  EXPECT_EQ(scene.camera.frame, CameraFrame::kBody);
}

TEST_F(FullScene, ReadsFigures) {
  const Show& show = scene.show;
  EXPECT_EQ(show.title, "Tennis racket");
  EXPECT_EQ(show.subtitle, "about its middle axis");
  EXPECT_EQ(show.exaggerateAngles, 100);
  EXPECT_FALSE(show.labels || show.body.visible || show.principalAxes.visible || show.L.visible ||
               show.omega.visible || show.ellipsoid.visible || show.plane.visible || show.contact.visible ||
               show.polhode.visible || show.herpolhode.visible || show.height.visible);
  EXPECT_EQ(show.body.scale, 1.5);
  ASSERT_EQ(show.body.parts.size(), 1u);
  EXPECT_EQ(solidOf<physics::Cylinder>(show.body.parts[0]).radius_m, 0.5);
  EXPECT_EQ(solidOf<physics::Cylinder>(show.body.parts[0]).height_m, 3);
  EXPECT_EQ(show.principalAxes.scale, 2);
  EXPECT_EQ(show.L.scale, 0.5);
  EXPECT_EQ(show.omega.scale, 0.75);
  EXPECT_EQ(show.contact.scale, 3);
  EXPECT_EQ(show.ellipsoid.scale, 1.1);
  EXPECT_EQ(show.ellipsoid.opacity, 0.3);
  EXPECT_EQ(show.plane.opacity, 0.4);
  EXPECT_FALSE(show.ellipsoid.graticule || show.plane.grid || show.herpolhode.future);
}

TEST_F(FullScene, ReadsStyleAndOutput) {
  EXPECT_EQ(scene.style.theme, Theme::kDark);
  EXPECT_EQ(scene.style.lineWidth, 1.5);
  EXPECT_EQ(scene.style.textSize, 1.25);
  EXPECT_EQ(scene.output.width, 1280);  // size and crf override quality
  EXPECT_EQ(scene.output.height, 720);
  EXPECT_EQ(scene.output.crf, 20);
}

Scene minimalWith(const std::vector<std::string>& overrides) {
  return parseScene(kMinimal, "test.toml", overrides);
}

TEST(Quality, SetsSizeAndRateFactor) {
  const Scene scene = minimalWith({"output.quality=preview"});
  EXPECT_EQ(scene.output.width, 640);
  EXPECT_EQ(scene.output.height, 360);
  EXPECT_EQ(scene.output.crf, 23);
  EXPECT_EQ(minimalWith({"output.quality=4k", "output.crf=0"}).output.crf, 0);
  EXPECT_EQ(minimalWith({"output.quality=4k", "output.crf=0"}).output.width, 3840);
  EXPECT_EQ(qualityPreset("720p")->height, 720);
  EXPECT_EQ(qualityPreset("720"), nullptr);
}

// Uniform solids, by the textbook formulas with M = 12 kg: box I_x = M(b² + c²)/12, ellipsoid M(b² + c²)/5 with
// semi-axes, cylinder I_z = M r²/2.
TEST(Shapes, DetermineTheMomentsOfTheBody) {
  const auto moments = [](const std::string& shape, const std::string& size) {
    return parseScene("[body]\nshape = \"" + shape + "\"\nmass = 12\nsize = " + size +
                          "\n[motion]\nomega_body = [1, 0, 0]",
                      "test.toml")
        .body.axes.moments()
        .values();
  };
  EXPECT_TRUE(moments("box", "[1, 2, 3]").isApprox(Eigen::Vector3d(13, 10, 5)));
  EXPECT_TRUE(moments("box", "2").isApprox(Eigen::Vector3d(8, 8, 8)));
  EXPECT_TRUE(moments("ellipsoid", "[2, 4, 6]").isApprox(Eigen::Vector3d(31.2, 24, 12)));
  EXPECT_TRUE(moments("cylinder", "[2, 2, 1]").isApprox(Eigen::Vector3d(4, 4, 6)));
}

TEST(DrawnShape, TakesItsSizeFromTheBodyOrADefault) {
  EXPECT_TRUE(minimalWith({}).show.body.parts.empty());
  const auto racket = minimalWith({"show.body.shape=racket"}).show.body.parts;
  ASSERT_EQ(racket.size(), 1u);
  EXPECT_EQ(solidOf<physics::Racket>(racket[0]).length_m, 0.685);  // default of docs/scene.md
  const std::vector<std::string> box = {"body={shape=\"box\", size=[3, 2, 1], mass=1}",
                                        "show.body.shape=ellipsoid"};
  const auto asBody = parseScene("motion.omega_body = [1, 1, 1]", "test.toml", box).show.body.parts;
  ASSERT_EQ(asBody.size(), 1u);
  EXPECT_EQ(solidOf<physics::Ellipsoid>(asBody[0]).semiAxes_m, Eigen::Vector3d(1.5, 1, 0.5));
}

TEST(Overrides, AcceptTomlValuesAndBareWords) {
  EXPECT_EQ(minimalWith({"time.duration=5"}).time.duration_s, 5);
  EXPECT_EQ(minimalWith({"time.duration=2 min"}).time.duration_s, 120);
  EXPECT_EQ(minimalWith({"time.duration=\"2 min\""}).time.duration_s, 120);
  EXPECT_EQ(minimalWith({"motion.L_points=down"}).motion.lPoints, LPoints::kDown);
  EXPECT_EQ(minimalWith({"time.fps=30000/1001"}).time.fps, (core::Rational{30000, 1001}));
  EXPECT_EQ(minimalWith({"output.size=[320, 240]"}).output.width, 320);
  EXPECT_EQ(minimalWith({"show.title=a = b"}).show.title, "a = b");
  EXPECT_EQ(minimalWith({"time.speed=auto"}).time.speed, std::nullopt);
  EXPECT_EQ(minimalWith({"camera.zoom=2", "camera.zoom=3"}).camera.zoom, 3);  // the last wins
  EXPECT_FALSE(minimalWith({"show.plane=false"}).show.plane.visible);
  EXPECT_EQ(minimalWith({"camera={zoom=2, frame=\"body\"}"}).camera.zoom, 2);
}

TEST(Overrides, ReplaceValuesOfTheFile) {
  const std::string text =
      std::string(kMinimal) + "[show.plane]\nvisible = true\nopacity = 0.5\n[time]\nfps = 0\n";
  const Scene scene = parseScene(text, "test.toml", {"show.plane=false", "time.fps=25"});
  EXPECT_FALSE(scene.show.plane.visible);
  EXPECT_EQ(scene.show.plane.opacity, 0.5);
  EXPECT_EQ(scene.time.fps.num, 25);  // a replaced value is not checked
}

TEST(FrameRate, IsReadAsAnExactFraction) {
  EXPECT_EQ(minimalWith({"time.fps=29.97"}).time.fps, (core::Rational{2997, 100}));
  EXPECT_EQ(minimalWith({"time.fps=\"60000/1001\""}).time.fps, (core::Rational{60000, 1001}));
  EXPECT_EQ(minimalWith({"time.fps=1000"}).time.fps, (core::Rational{1000, 1}));
}

TEST(SceneFile, AcceptsWindowsLineEndsAndByteOrderMark) {
  std::string text = kMinimal;
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, "\r");
  EXPECT_NO_THROW(parseScene("\xef\xbb\xbf" + text, "test.toml"));
}

TEST(SceneFile, BodyAtRestIsAcceptedIfItsFiguresAreHidden) {
  std::vector<std::string> hidden = {"motion.omega_body=[0, 0, 0]", "motion.orientation=[1, 0, 0, 0]"};
  for (const char* thing : {"L", "omega", "ellipsoid", "plane", "contact", "polhode", "herpolhode", "height"})
    hidden.push_back("show." + std::string(thing) + "=false");
  EXPECT_EQ(messagesOf(kMinimal, hidden), "");
}

TEST(Gallery, HoldsValidScenesThatBeginWithAComment) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(POINSOT_SOURCE_DIR) + "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    ++count;
    EXPECT_NO_THROW(loadScene(entry.path())) << entry.path();
    EXPECT_EQ(std::ifstream(entry.path()).peek(), '#') << entry.path();
  }
  EXPECT_GE(count, 7);
}

class UnreadableScene : public testing::Test {
 protected:
  std::string messageOf(const std::string& name) const {
    try {
      loadScene(folder_ + "/" + name);
    } catch (const core::Error& error) {
      EXPECT_EQ(error.kind(), core::ErrorKind::kScene);
      return error.what();
    }
    return "";
  }

  const ScratchFolder scratch_;
  const std::string folder_ = scratch_.path();
};

// The columns were counted by hand.
TEST(TextCheck, ReportsTexErrorsTogetherWithOtherErrors) {
  const std::string text = std::string(kMinimal) + "[show]\n  title = 'a'\n  subtitle = 'fine'\nzom = 1\n";
  const auto check = [](std::string_view tex) { return tex == "fine" ? "" : "no " + std::string(tex); };
  try {
    parseScene(text, "some.toml", {"show.subtitle=b"}, check);
    FAIL() << "nothing was thrown";
  } catch (const SceneErrors& errors) {
    const std::string report = errors.what();
    EXPECT_NE(report.find("some.toml:6:11: error: show.title: no a"), std::string::npos) << report;
    EXPECT_NE(report.find("-D show.subtitle=b: error: show.subtitle: no b"), std::string::npos) << report;
    EXPECT_NE(report.find("some.toml:8:1: error: show.zom: unknown key"), std::string::npos) << report;
  }
  EXPECT_EQ(parseScene(std::string(kMinimal), "some.toml", {}, check).show.title, "");
}

TEST_F(UnreadableScene, ReportsTheReason) {
  EXPECT_EQ(messageOf("none.toml"), folder_ + "/none.toml: cannot read the scene: No such file or directory");
  EXPECT_EQ(messageOf(""), folder_ + "/: cannot read the scene: it is a directory");
  ASSERT_EQ(::mkfifo((folder_ + "/fifo.toml").c_str(), 0600), 0);
  EXPECT_EQ(messageOf("fifo.toml"), folder_ + "/fifo.toml: cannot read the scene: it is not a regular file");
}

TEST_F(UnreadableScene, MessageEscapesControlCharacters) {
  EXPECT_EQ(messageOf("a\x1b[31m.toml").find('\x1b'), std::string::npos);
}

TEST(OptionalFigures, AreShownIfAnyOfTheirKeysIsGiven) {
  const auto parse = [](const std::string& more) { return parseScene(kMinimal + more, "test.toml"); };
  const auto figures = [&](const std::string& show) { return parse(show).show.figures; };
  EXPECT_FALSE(figures("").trace.visible);
  EXPECT_TRUE(figures("[show.trace]\nopacity = 0.2\n").trace.visible);
  EXPECT_FALSE(figures("[show.trace]\nopacity = 0.2\nvisible = false\n").trace.visible);
  EXPECT_FALSE(figures("[show.trace]\nvisible = false\nfuture = false\n").trace.visible);
  EXPECT_FALSE(parse("[show.plane]\nvisible = false\nopacity = 0.3\n").show.plane.visible);
  const Scene views = parse("[[view]]\n[[view]]\nshow.ghosts.count = 3\n");
  EXPECT_FALSE(views.views[0].show.figures.ghosts.visible);
  EXPECT_TRUE(views.views[1].show.figures.ghosts.visible);
}

}  // namespace
}  // namespace poinsot::scene
