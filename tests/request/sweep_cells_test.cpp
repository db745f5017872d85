// SPDX-License-Identifier: Apache-2.0
// Cells of a sweep: their order, the settings which they share, and their limits.
#include "request/sweep_cells.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/error.h"
#include "request/requested_scene.h"
#include "scene/motion/make_motion.h"

namespace poinsot::request {
namespace {

using testing::HasSubstr;

constexpr const char* kScene =
    "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 2, 0]\n[time]\nduration = 4\n"
    "[show]\ntitle = 'Spin'\n";
const std::string kOne = "motion.omega_body=[0.1..0.3:3, 2, 0]", kSpeeds = "time.speed=1..2:2";

SceneRequest asked(const std::vector<std::string>& overrides, const SweepRequest& sweep = {}) {
  return {.fileName = "spin.toml",
          .text = kScene,
          .overrides = overrides,
          .size = std::nullopt,
          .allowance = {},
          .sweep = sweep};
}

std::vector<scene::Scene> cellsOf(const SceneRequest& request) { return requestedScene(request).cells; }

core::Error refusal(const SceneRequest& request) {
  try {
    cellsOf(request);
  } catch (const core::Error& error) {
    return error;
  }
  return {core::ErrorKind::kIo, "none"};
}

TEST(SweepCells, VaryTheFirstRangeAlongEachRow) {
  const auto cells = cellsOf(asked({kOne, "time.duration=6", kSpeeds}));
  ASSERT_EQ(cells.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(cells[i].motion.omega_B.x(), 0.1 * static_cast<double>(i % 3 + 1), 1e-15) << i;
    EXPECT_EQ(cells[i].time.speed, i < 3 ? 1.0 : 2.0) << i;
    EXPECT_EQ(cells[i].time.duration_s, 6);  // an override without a range holds for all cells
  }
  const auto first = loadRequested(asked({kOne, kSpeeds}));
  EXPECT_EQ(first.motion.omega_B, cells[0].motion.omega_B);
}

// Alone, each cell would choose a speed for its own omega. In a sweep all cells use the slowest of these speeds.
TEST(SweepCells, PlayAtTheSlowestSpeedOfAllCells) {
  const auto request = asked({"motion.omega_body=[0.1, 2..20:3, 0]"});
  const SweepGrid grid(request);
  const auto cells = cellsOf(request);
  double least = 1e300;
  std::set<double> chosen;
  for (int i = 0; i < grid.cells; ++i) {
    chosen.insert(scene::chosenSpeed(loadRequested(cellRequest(request, grid, i))));
    least = std::min(least, *chosen.begin());
  }
  EXPECT_GT(chosen.size(), 1u);
  for (const scene::Scene& cell : cells) EXPECT_EQ(cell.time.speed, least);
}

TEST(SweepCells, MustHaveEqualFilmSettings) {
  for (const char* word : {"time.duration=1..2:2", "output.crf=10..20:2"}) {
    const core::Error error = refusal(asked({word}));
    EXPECT_EQ(error.kind(), core::ErrorKind::kUsage) << word;
    EXPECT_THAT(error.what(), HasSubstr("they must agree in length, rate, size and paper")) << word;
  }
  EXPECT_THAT(refusal(asked({kOne, "time.loop=true"})).what(), HasSubstr("a sweep cannot repeat"));
}

TEST(SweepCells, RejectTooManyCellsOrRanges) {
  EXPECT_EQ(cellsOf(asked({"motion.omega_body=[0..1:10, 2, 0]", "time.speed=1..2:10"})).size(), 100u);
  EXPECT_THAT(refusal(asked({kOne, "time.speed=1..2:34"})).what(), HasSubstr("3 x 34 are 102 cells"));
  EXPECT_THAT(refusal(asked({})).what(), HasSubstr("one range or two"));
  EXPECT_THAT(refusal(asked({kOne, kSpeeds, "time.start=0..1:2"})).what(), HasSubstr("one range or two, got 3"));
  EXPECT_THAT(refusal(asked({kOne}, {.map = true})).what(), HasSubstr("--map shows one body"));
}

TEST(SweepCells, OfInstantsAreWithinTheFilm) {
  const auto cells = cellsOf(asked({"time.still=0|1.5|4"}));
  ASSERT_EQ(cells.size(), 3u);
  EXPECT_EQ(cells[1].time.stillTime_s(), 1.5);
  EXPECT_THAT(refusal(asked({"time.still=0|1.5|4.1"})).what(),
              HasSubstr("a cell at 4.1 s: the film lasts from 0 to 4 s"));
  EXPECT_THAT(refusal(asked({"time.still=auto|auto"})).what(), HasSubstr("a range has times"));
}

TEST(SweepCells, OfAnInstantHaveOneTimeOfTheMotion) {
  EXPECT_EQ(cellsOf(asked({"time.still=0|1.5", kOne})).size(), 6u);
  for (const char* range : {"time.speed=1..2:2", "time.start=0..2:3"}) {
    const core::Error error = refusal(asked({"time.still=1|1.5", range}));
    EXPECT_EQ(error.kind(), core::ErrorKind::kUsage);
    EXPECT_THAT(error.what(), HasSubstr("changes the time of the motion")) << range;
  }
}

// The last override of a key wins, so that a range before it would give equal cells.
TEST(SweepCells, RejectASecondOverrideOfAKeyWithARange) {
  for (const char* other : {"time.speed=3", " time.speed =3", "time.speed=3..4:2"}) {
    EXPECT_THAT(refusal(asked({kSpeeds, other})).what(), HasSubstr("-D time.speed: given more than once"));
    EXPECT_THAT(refusal(asked({other, kSpeeds})).what(), HasSubstr("-D time.speed: given more than once"));
  }
  EXPECT_EQ(cellsOf(asked({kSpeeds, "time.start=3"})).size(), 2u);
}

TEST(SweepCells, NameTheValueOfTheFaultyCell) {
  const core::Error error = refusal(asked({"camera.elevation=80..200 deg:2"}));
  EXPECT_EQ(error.kind(), core::ErrorKind::kScene);
  EXPECT_THAT(error.what(), HasSubstr("-D camera.elevation=200 deg"));
}

// Limits on text and on integration steps hold for all cells together.
TEST(SweepCells, ShareTheLimitsOfOneScene) {
  auto request = asked({kOne});
  request.allowance.limits.set(scene::Limit::kCharacters, std::int64_t{11});
  EXPECT_THAT(refusal(request).what(), HasSubstr("at most 3 characters, got 4"));  // "Spin" in each of three cells
  request.allowance.limits.set(scene::Limit::kCharacters, std::int64_t{12});
  request.allowance.limits.set(scene::Limit::kSteps, std::int64_t{3000});
  const auto cells = cellsOf(request);
  for (const scene::Scene& cell : cells) EXPECT_EQ(cell.motion.mostSteps, 1000);
}

}  // namespace
}  // namespace poinsot::request
