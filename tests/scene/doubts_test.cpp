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
  const std::string handle = "[[body.part]]\nshape = 'cube'\nedge = 32\nmass = 4e4\n";
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

std::string bodyDoubts(const std::string& body) {
  std::string lines;
  for (const Doubt& doubt : parseScene("[motion]\nomega_body = [0, 1, 0.1]\n[body]\n" + body, "test.toml").doubts)
    lines += toString(doubt) + "\n";
  return lines;
}

// A phone of 14.67 cm x 7.15 cm x 0.78 cm and 174 g has 174 g / 81.8 cm^3 = 2127 kg/m^3, or 0.0021 kg/m^3 if the
// lengths are metres.
TEST(SceneNotes, WarnAboutAPhoneOfFourteenMetres) {
  EXPECT_EQ(
      bodyDoubts("shape = 'box'\nsize = [14.67, 7.15, 0.78]\nmass = 0.174\n"),
      "test.toml:5:8: note: body.size: is in metres, so the mean density is 0.0021 kg/m^3, less than that of "
      "air; for cm write \"14.67 cm\"\n");
  EXPECT_EQ(
      bodyDoubts("shape = 'box'\nsize = [146.7, 71.5, 7.8]\nmass = '174 g'\n"),
      "test.toml:5:8: note: body.size: is in metres, so the mean density is 2.1e-06 kg/m^3, less than that of "
      "air; for mm write \"146.7 mm\"\n");
  EXPECT_EQ(bodyDoubts("shape = 'box'\nsize = ['14.67 cm', '7.15 cm', '0.78 cm']\nmass = 0.174\n"), "");
  EXPECT_EQ(bodyDoubts("shape = 'box'\nsize = [3, 2, 1]\nmass = 1\n"), "");  // an example in round numbers
  EXPECT_EQ(bodyDoubts("shape = 'sphere'\nradius = 5\nmass = 300\n"), "");   // a hot-air balloon
  EXPECT_EQ(bodyDoubts("shape = 'sphere'\nradius = 6.4e6\nmass = 6e24\n"), "");
}

TEST(SceneNotes, WarnAboutGramsAsKilograms) {
  EXPECT_EQ(
      bodyDoubts("shape = 'box'\nsize = ['14.67 cm', '7.15 cm', '0.78 cm']\nmass = 174\n"),
      "test.toml:6:8: note: body.mass: 174 is in kilograms, so the mean density is 2.1e+06 kg/m^3, higher than "
      "that of any metal; for grams write \"174 g\"\n");
}

TEST(SceneNotes, WarnAboutQuarterTurnsInRadiansPerSecond) {
  EXPECT_EQ(
      doubts("", {"motion.omega_body=[0, 360, 0.1]"}),
      "-D motion.omega_body=[0, 360, 0.1]: note: motion.omega_body: 360 is in rad/s (57.3 turns per second); "
      "for degrees per second write \"360 deg/s\"\n");
  EXPECT_NE(doubts("", {"motion.omega_body=[0, -90.0, 0]"}).find("-90 is in rad/s"), std::string::npos);
  EXPECT_EQ(doubts("", {"motion.omega_body=[0, '360 deg/s', 100]"}), "");
}

TEST(SceneNotes, WarnAboutACaptionOverAnother) {
  const std::string first = "[[timeline]]\nat = 1\ncaption = 'A'\n";
  EXPECT_EQ(
      doubts(first + "[[timeline]]\nat = 1\ncaption = 'B'\n"),
      "test.toml:7:11: note: timeline[0].caption: is never shown, because timeline[1].caption also begins at "
      "1 s\n");
  EXPECT_EQ(
      doubts(first + "caption_for = 5\n[[timeline]]\nat = 3\ncaption = 'B'\n"),
      "test.toml:8:15: note: timeline[0].caption_for: would last until 6 s, but timeline[1].caption replaces "
      "this caption at 3 s\n");
  EXPECT_EQ(doubts(first + "caption_for = 2\n[[timeline]]\nat = 3\ncaption = 'B'\n"), "");
  EXPECT_EQ(doubts(first + "[[timeline]]\nat = 3\ncaption = 'B'\n"), "");
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
