// SPDX-License-Identifier: Apache-2.0
// The scripts that submit prints, run by what they are for: a real Slurm of two nodes, GNU parallel, make. One
// task of each is killed. The rest, which takes a minute, is in clusters_nightly_test.cpp.
#include <gmock/gmock.h>

#include <cstdio>

#include "faults/slurm_fixture.h"

namespace poinsot::faults {
namespace {

using testing::ElementsAre;

// Of a Slurm array one task has the number of the whole as its own. It is the last: it is killed while it makes
// its second segment, comes back, alone, and goes on.
TEST_F(Slurm, ATaskThatFailsComesBackAndTheFilmHasTheBytesOfALocalRun) {
  film_.writeScript("slurm");
  film_.breakShard(SubmittedFilm::kTasks, true);
  const Watch watch;
  submit("cd / && bash \"$script\"");
  waitForTheEnd();
  const double slurm_s = watch.seconds();
  EXPECT_TRUE(film_.died());
  expectTheBytesOfALocalRun();
  EXPECT_THAT(cluster_->restarts(SubmittedFilm::kTasks), ElementsAre(0, 0, 1));
  std::printf("[ measured ] local run %.1f s; Slurm %.1f s, 6 s of which a requeued task waits\n", film_.local_s(),
              slurm_s);
}

TEST(Parallel, ATaskThatFailsIsTriedAgainAndTheFilmHasTheBytesOfALocalRun) {
  if (!isInstalled("parallel")) GTEST_SKIP() << "GNU parallel is not installed";
  SubmittedFilm film;
  film.writeScript("parallel");
  film.breakShard(2, true);
  const Watch watch;
  const ShellResult made = film.shell("cd / && bash \"$script\" --jobs 2", film.broken());
  const double parallel_s = watch.seconds();
  EXPECT_EQ(made.exitCode, 0) << made.out;
  EXPECT_TRUE(film.died());
  film.expectTheBytesOfALocalRun(made.out);
  std::printf("[ measured ] local run %.1f s; parallel %.1f s\n", film.local_s(), parallel_s);
}

TEST(Make, ATaskThatFailsIsGoneOnWithAndTheFilmHasTheBytesOfALocalRun) {
  if (!isInstalled("make")) GTEST_SKIP() << "make is not installed";
  SubmittedFilm film(SubmittedFilm::kFolderForMake);
  film.writeScript("make");
  film.breakShard(2, false);
  EXPECT_EQ(film.shell("cd / && make -k -j 2 -f \"$script\"", film.broken()).exitCode, 2);
  EXPECT_TRUE(film.died());
  EXPECT_FALSE(film.hasFilm());
  EXPECT_EQ(film.shell("ls film.mp4.tasks").out, "1\n3\n");  // these are not made again
  film.repair();
  const Watch watch;
  const ShellResult made = film.shell("cd / && make -j 2 -f \"$script\"", film.broken());
  const double make_s = watch.seconds();
  EXPECT_EQ(made.exitCode, 0) << made.out;
  film.expectTheBytesOfALocalRun(made.out);
  std::printf("[ measured ] local run %.1f s; make %.1f s for the third that failed, and the joining\n",
              film.local_s(), make_s);
}

TEST(Make, MakesAFilmAgainWhenItsSceneIsNewerAndOnlyThen) {
  if (!isInstalled("make")) GTEST_SKIP() << "make is not installed";
  SubmittedFilm film(SubmittedFilm::kFolderForMake);
  film.writeScript("make");
  ASSERT_EQ(film.shell("make -j 2 -f \"$script\"").exitCode, 0);
  EXPECT_EQ(film.shell("ls -d film.mp4.tasks").exitCode, 2);
  EXPECT_EQ(film.shell("make -q -f \"$script\"").exitCode, 0);
  EXPECT_EQ(film.shell("touch -d '1 minute' tiny.toml; make -q -f \"$script\"").exitCode, 1);
}

}  // namespace
}  // namespace poinsot::faults
