// SPDX-License-Identifier: Apache-2.0
// What a sweep asks for: its cells, what they have in common, and what bounds them.
#include "request/sweep_cells.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/error.h"
#include "describe/picture_words.h"
#include "job/job_identity.h"
#include "job/worker_protocol.h"
#include "scene/motion/make_motion.h"

namespace poinsot::request {
namespace {

using testing::HasSubstr;

constexpr const char* kScene =
    "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 2, 0]\n[time]\nduration = 4\n"
    "[show]\ntitle = 'Spin'\n";
const std::string kOne = "motion.omega_body=[0.1..0.3:3, 2, 0]", kSpeeds = "time.speed=1..2:2";

SceneRequest requested(const std::vector<std::string>& overrides, const SweepRequest& sweep = {}) {
  return {.fileName = "spin.toml",
          .text = kScene,
          .overrides = overrides,
          .size = std::nullopt,
          .allowance = {},
          .sweep = sweep};
}

std::vector<scene::Scene> cellsOf(const SceneRequest& request) { return loadCells(request, SweepGrid(request)); }

core::Error refusal(const SceneRequest& request) {
  try {
    cellsOf(request);
  } catch (const core::Error& error) {
    return error;
  }
  return {core::ErrorKind::kIo, "none"};
}

TEST(SweepCells, RunRowByRowTheFirstRangeAlongTheRows) {
  const auto cells = cellsOf(requested({kOne, "time.duration=6", kSpeeds}));
  ASSERT_EQ(cells.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(cells[i].motion.omega_B.x(), 0.1 * static_cast<double>(i % 3 + 1), 1e-15) << i;
    EXPECT_EQ(cells[i].time.speed, i < 3 ? 1.0 : 2.0) << i;
    EXPECT_EQ(cells[i].time.duration_s, 6);  // the word between the ranges holds for all
  }
  const auto first = loadRequested(requested({kOne, kSpeeds}));
  EXPECT_EQ(first.motion.omega_B, cells[0].motion.omega_B);
}

// Each by itself would choose a speed for its own omega; on one clock no spin is faster than any would choose.
TEST(SweepCells, HaveOneSpeed) {
  const auto request = requested({"motion.omega_body=[0.1, 2..20:3, 0]"});
  const SweepGrid grid(request);
  const auto cells = loadCells(request, grid);
  double least = 1e300;
  std::set<double> chosen;
  for (int i = 0; i < grid.cells; ++i) {
    chosen.insert(scene::chosenSpeed(loadRequested(cellRequest(request, grid, i))));
    least = std::min(least, *chosen.begin());
  }
  EXPECT_GT(chosen.size(), 1u);
  for (const scene::Scene& cell : cells) EXPECT_EQ(cell.time.speed, least);
}

TEST(SweepCells, AreOneFilm) {
  for (const char* word : {"time.duration=1..2:2", "output.crf=10..20:2"}) {
    const core::Error error = refusal(requested({word}));
    EXPECT_EQ(error.kind(), core::ErrorKind::kUsage) << word;
    EXPECT_THAT(error.what(), HasSubstr("its cells would differ in length, rate, size or paper")) << word;
  }
  EXPECT_THAT(refusal(requested({kOne, "time.loop=true"})).what(), HasSubstr("a sweep does not repeat"));
}

TEST(SweepCells, AreAsManyAsAPictureCanShow) {
  EXPECT_EQ(cellsOf(requested({"motion.omega_body=[0..1:10, 2, 0]", "time.speed=1..2:10"})).size(), 100u);
  EXPECT_THAT(refusal(requested({kOne, "time.speed=1..2:34"})).what(), HasSubstr("3 x 34 are 102 cells"));
  EXPECT_THAT(refusal(requested({})).what(), HasSubstr("one range or two"));
  EXPECT_THAT(refusal(requested({kOne, kSpeeds, "time.start=0..1:2"})).what(),
              HasSubstr("one range or two, got 3"));
  EXPECT_THAT(refusal(requested({kOne}, {.map = true})).what(), HasSubstr("--map is of one body"));
}

// The last word for a key wins, so that a range before it would be drawn as so many equal cells.
TEST(SweepCells, ARangeIsTheOnlyWordForItsKey) {
  for (const char* other : {"time.speed=3", " time.speed =3", "time.speed=3..4:2"}) {
    EXPECT_THAT(refusal(requested({kSpeeds, other})).what(), HasSubstr("-D time.speed: given more than once"));
    EXPECT_THAT(refusal(requested({other, kSpeeds})).what(), HasSubstr("-D time.speed: given more than once"));
  }
  EXPECT_EQ(cellsOf(requested({kSpeeds, "time.start=3"})).size(), 2u);
}

TEST(SweepCells, MistakesAreSaidWithTheValueThatTheyAreAbout) {
  const core::Error error = refusal(requested({"camera.elevation=80..200 deg:2"}));
  EXPECT_EQ(error.kind(), core::ErrorKind::kScene);
  EXPECT_THAT(error.what(), HasSubstr("-D camera.elevation=200 deg"));
}

// A scene's text and steps are bounded; nine scenes may not have nine times as much.
TEST(SweepCells, WhatBoundsASceneBoundsAllCells) {
  auto request = requested({kOne});
  request.allowance.limits.set(scene::Limit::kCharacters, std::int64_t{11});
  EXPECT_THAT(refusal(request).what(), HasSubstr("at most 3 characters, got 4"));  // "Spin" in each of three
  request.allowance.limits.set(scene::Limit::kCharacters, std::int64_t{12});
  request.allowance.limits.set(scene::Limit::kSteps, std::int64_t{3000});
  const auto cells = cellsOf(request);
  for (const scene::Scene& cell : cells) EXPECT_EQ(cell.motion.mostSteps, 1000);
}

TEST(SweepRequest, TravelsToTheWorker) {
  job::WorkerJob job{requested({kOne}, {.map = false, .columns = 4, .labels = {"$a$", "ö\xff"}}), {}, {}, {}, {}};
  const auto there = job::jobFromLine(job::toLine(job)).scene.sweep;
  ASSERT_TRUE(there);
  EXPECT_EQ(there->columns, 4);
  EXPECT_EQ(there->labels, job.scene.sweep->labels);
  EXPECT_FALSE(there->map);
  job.scene.sweep = SweepRequest{.map = true};
  EXPECT_TRUE(job::jobFromLine(job::toLine(job)).scene.sweep->map);
  job.scene.sweep.reset();
  EXPECT_FALSE(job::jobFromLine(job::toLine(job)).scene.sweep);
}

// A render that goes on must not take another sweep's segments for its own.
TEST(SweepRequest, IsPartOfAJobsIdentity) {
  std::set<core::Digest> digests;
  const auto add = [&](const SceneRequest& request) { digests.insert(job::sceneDigest(request, {})); };
  add(requested({kOne}));
  add(requested({"motion.omega_body=[0.1..0.3:4, 2, 0]"}));
  add(requested({kOne}, {.columns = 2}));
  add(requested({kOne}, {.labels = {"$a$"}}));
  add(requested({kOne}, {.map = true}));
  auto plain = requested({kOne});
  plain.sweep.reset();
  add(plain);
  plain.view = 1;
  add(plain);
  EXPECT_EQ(digests.size(), 7u);
}

TEST(PictureWords, OfASweepAndAMapSayWhatIsSeen) {
  const auto grid = requested({kOne, kSpeeds});
  const std::string words = describe::pictureWords(grid, loadRequested(grid)).description;
  EXPECT_THAT(words,
              HasSubstr("6 pictures of one scene side by side, at one instant: ω₁ from 0.1 rad/s to 0.3 rad/s "
                        "from left to right, speed from 1 to 2 from top to bottom."));
  const auto map = requested({}, {.map = true});
  // Half periods 2K/lambda of the limits: pi/(w sqrt((I_k - I_i)(I_k - I_j)/(I_i I_j))), w = |L|/I_k, |L|
  // = 4.00125.
  EXPECT_THAT(describe::pictureWords(map, loadRequested(map)).description,
              HasSubstr("from 1.36 s in dark colours at the axes e1 and e3, the stable ones"));
}

}  // namespace
}  // namespace poinsot::request
