// SPDX-License-Identifier: Apache-2.0
// What a scene may say and can hardly mean: it is taken as it stands, and told.

#include "scene_testing.h"

namespace poinsot::scene {
namespace {

std::string doubts(const std::string& more, const std::vector<std::string>& overrides = {}) {
  std::string lines;
  for (const Doubt& doubt : parseScene(kMinimal + more, "test.toml", overrides).doubts)
    lines += toString(doubt) + "\n";
  return lines;
}

TEST(Doubts, WholeNumbersAsAngles) {
  EXPECT_EQ(doubts("[camera]\nelevation = 1\nazimuth = 2.0\n"),
            "test.toml:6:13: note: camera.elevation: 1 is in radians, 57.3 deg; for degrees write \"1 deg\"\n"
            "test.toml:7:11: note: camera.azimuth: 2 is in radians, 115 deg; for degrees write \"2 deg\"\n");
  EXPECT_EQ(
      doubts("", {"camera.azimuth=-1"}),
      "-D camera.azimuth=-1: note: camera.azimuth: -1 is in radians, -57.3 deg; for degrees write \"-1 deg\"\n");
  EXPECT_EQ(parseScene(kMinimal, "test.toml", {"camera.azimuth=1"}).camera.azimuth_rad, 1);
}

TEST(Doubts, NotWhatRadiansLookLike) {
  EXPECT_EQ(doubts("[camera]\nelevation = 0.5236\nazimuth = 0\norbit = \"1 rad\"\nfov = \"30 deg\"\n"), "");
  EXPECT_EQ(doubts("", {"camera.azimuth=\"1 deg\"", "time.start=1"}), "");
}

TEST(Doubts, AHoldBeyondTheFilm) {
  EXPECT_EQ(doubts("[time]\nduration = 5\n[[timeline]]\nat = 3\nover = 1\nhold = 2\n"),
            "test.toml:10:8: note: timeline[0].hold: would last till 6 s, the film ends at 5 s (time.duration)\n");
  EXPECT_EQ(doubts("[time]\nduration = 5\n[[timeline]]\nat = 3\nover = 1\nhold = 1\n"), "");
}

}  // namespace
}  // namespace poinsot::scene
