// SPDX-License-Identifier: Apache-2.0
// Doubts are notes on values that a scene may give but hardly means. The scene is accepted as written.

#include "scene_testing.h"

namespace poinsot::scene {
namespace {

std::string doubts(const std::string& more, const std::vector<std::string>& overrides = {}) {
  std::string lines;
  for (const Doubt& doubt : parseScene(kMinimal + more, "test.toml", overrides).doubts)
    lines += toString(doubt) + "\n";
  return lines;
}

TEST(SceneNotes, WarnAboutWholeNumbersOfRadians) {
  EXPECT_EQ(doubts("[camera]\nelevation = 1\nazimuth = 2.0\n"),
            "test.toml:6:13: note: camera.elevation: 1 is in radians (57.3 deg); for degrees write \"1 deg\"\n"
            "test.toml:7:11: note: camera.azimuth: 2 is in radians (115 deg); for degrees write \"2 deg\"\n");
  EXPECT_EQ(
      doubts("", {"camera.azimuth=-1"}),
      "-D camera.azimuth=-1: note: camera.azimuth: -1 is in radians (-57.3 deg); for degrees write \"-1 deg\"\n");
  EXPECT_EQ(parseScene(kMinimal, "test.toml", {"camera.azimuth=1"}).camera.azimuth_rad, 1);
}

TEST(SceneNotes, AreAbsentForAnglesWithFractionsOrUnits) {
  EXPECT_EQ(doubts("[camera]\nelevation = 0.5236\nazimuth = 0\norbit = \"1 rad\"\nfov = \"30 deg\"\n"), "");
  EXPECT_EQ(doubts("", {"camera.azimuth=\"1 deg\"", "time.start=1"}), "");
}

TEST(SceneNotes, WarnAboutMetresAmongCentimetres) {
  const std::string start = "[motion]\nomega_body = [0, 1, 0.1]\n";
  const auto said = [&](const std::string& body) {
    std::string lines;
    for (const Doubt& doubt : parseScene(start + body, "test.toml").doubts) lines += toString(doubt) + "\n";
    return lines;
  };
  const std::string handle = "[[body.part]]\nshape = 'cube'\nedge = 32\nmass = 1\n";
  EXPECT_EQ(said(handle + "[[body.part]]\nshape = 'cube'\nedge = '5 cm'\nmass = 1\n"),
            "test.toml:5:8: note: body.part[0].edge: 32 is in metres; other lengths of this body have a unit\n");
  EXPECT_EQ(said(handle), "");
  EXPECT_EQ(said("[[body.part]]\nshape = 'cube'\nedge = '5 cm'\nmass = 1\noffset = [0, 0, 0.4]\n"), "");
}

TEST(SceneNotes, WarnAboutADensityAboveThatOfOsmium) {
  const auto said = [](const std::string& density) {
    return parseScene("[motion]\nomega_body = [0, 1, 0]\n[body]\nshape = 'cube'\nedge = 1\ndensity = " + density,
                      "test.toml")
        .doubts.size();
  };
  EXPECT_EQ(said("'7850 g/cm^3'"), 1u);
  EXPECT_EQ(said("22590"), 0u);  // osmium
  EXPECT_EQ(said("'7.85 g/cm3'"), 0u);
}

TEST(SceneNotes, WarnAboutAThrownBodyOutsideThePicture) {
  const std::string thrown = "[motion.flight]\nvelocity = [3, 0, 4]\n";
  EXPECT_EQ(doubts(thrown + "[camera]\nzoom = 2\n"),
            "test.toml:8:8: note: camera.zoom: the thrown body starts and ends outside the picture, because a "
            "zoom of 1 shows its whole flight; set camera.follow = true to follow the body\n");
  EXPECT_EQ(doubts(thrown + "[[view]]\n[[view]]\ncamera.zoom = 2\n").substr(0, 47),
            "test.toml:9:15: note: view[1].camera.zoom: the ");
  EXPECT_EQ(doubts(thrown + "[camera]\nzoom = 2\nfollow = true\n"), "");
  EXPECT_EQ(doubts(thrown + "[camera]\nzoom = 2\nframe = 'body'\n"), "");
  EXPECT_EQ(doubts(thrown + "[camera]\nzoom = 1.1\n"), "");
  EXPECT_EQ(doubts("[camera]\nzoom = 2\n"), "");
}

TEST(SceneNotes, WarnAboutAHoldThatOutlastsTheFilm) {
  EXPECT_EQ(
      doubts("[time]\nduration = 5\n[[timeline]]\nat = 3\nover = 1\nhold = 2\n"),
      "test.toml:10:8: note: timeline[0].hold: would last until 6 s, but the film ends at 5 s (time.duration)\n");
  EXPECT_EQ(doubts("[time]\nduration = 5\n[[timeline]]\nat = 3\nover = 1\nhold = 1\n"), "");
}

}  // namespace
}  // namespace poinsot::scene
