// SPDX-License-Identifier: Apache-2.0
// Runs the scripts that submit prints with a real Slurm of two nodes, GNU parallel and make. One task of each is
// killed. clusters_nightly_test.cpp has the other tests, which take a minute.
#include <gmock/gmock.h>

#include <cstdio>

#include "faults/slurm_fixture.h"

namespace poinsot::faults {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::MatchesRegex;

// One task of a Slurm array has the number of the array as its own job number: the last. This task is killed in
// its second segment, is requeued alone, and goes on.
TEST_F(Slurm, RequeuesAKilledTaskAndGivesTheBytesOfALocalRun) {
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

// Variables of the shell do not reach the jobs, as on many clusters. The program named by POINSOT does.
TEST_F(Slurm, SubmitsOnlyTheJoinJobAgainIfItWasLost) {
  film_.writeScript("slurm");
  film_.breakJoining();
  submit("SBATCH_EXPORT=NONE bash \"$script\"");
  waitForTheEnd();
  EXPECT_FALSE(film_.hasFilm());
  EXPECT_EQ(film_.shell("ls film.mp4.tasks | grep -c _join.txt").out, "1\n");
  EXPECT_EQ(film_.shell("$poinsot status film.mp4").out,
            "film.mp4: 6 segments: 6 done\n"
            "not joined yet; run: poinsot assemble film.mp4\n");
  EXPECT_THAT(submit("bash \"$script\""), MatchesRegex("poinsot: joined by job [0-9]+\n"));
  waitForTheEnd();
  expectTheBytesOfALocalRun();
  EXPECT_EQ(submit("bash \"$script\""), "poinsot: film.mp4 is complete\n");
  EXPECT_EQ(film_.shell("$poinsot status film.mp4").out, "film.mp4: complete\n");
  // If tasks of a complete film are submitted by number, they end at once, and their joining succeeds.
  submit("bash \"$script\" 2");
  waitForTheEnd();
  EXPECT_EQ(cluster_->run("scontrol -o show job | grep -cv JobState=COMPLETED").out, "1\n");  // the lost joining
  EXPECT_EQ(film_.shell("$poinsot status film.mp4").out, "film.mp4: complete\n");
}

TEST(Parallel, RetriesAKilledTaskAndGivesTheBytesOfALocalRun) {
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
  const ShellResult again = film.shell("bash \"$script\" --jobs 2");
  EXPECT_EQ(again.exitCode, 0) << again.out;
  EXPECT_THAT(again.out, HasSubstr("poinsot: film.mp4 is complete: nothing is left to make for shard 3/3\n"));
  std::printf("[ measured ] local run %.1f s; parallel %.1f s\n", film.local_s(), parallel_s);
}

TEST(Make, ContinuesAFailedTaskAndGivesTheBytesOfALocalRun) {
  if (!isInstalled("make")) GTEST_SKIP() << "make is not installed";
  SubmittedFilm film(SubmittedFilm::kFolderForMake);
  film.writeScript("make");
  film.breakShard(2, false);
  EXPECT_EQ(film.shell("cd / && make -k -j 2 -f \"$script\"", film.broken()).exitCode, 2);
  EXPECT_TRUE(film.died());
  EXPECT_FALSE(film.hasFilm());
  EXPECT_EQ(film.shell("ls film.mp4.tasks").out, "1\n3\n");
  film.repair();
  film.breakJoining();
  EXPECT_EQ(film.shell("make -j 2 -f \"$script\"", film.broken()).exitCode, 2);
  EXPECT_FALSE(film.hasFilm());
  const Watch watch;
  const ShellResult made = film.shell("cd / && make -j 2 -f \"$script\"", film.broken());
  const double make_s = watch.seconds();
  EXPECT_EQ(made.exitCode, 0) << made.out;
  film.expectTheBytesOfALocalRun(made.out);
  std::printf("[ measured ] local run %.1f s; make %.1f s for what a joining that failed left to do\n",
              film.local_s(), make_s);
}

TEST(Make, MakesAFilmAgainOnlyIfItsSceneIsNewer) {
  if (!isInstalled("make")) GTEST_SKIP() << "make is not installed";
  SubmittedFilm film(SubmittedFilm::kFolderForMake);
  film.writeScript("make");
  ASSERT_EQ(film.shell("make -j 2 -f \"$script\"").exitCode, 0);
  EXPECT_EQ(film.shell("ls -d film.mp4.tasks").exitCode, 2);
  EXPECT_EQ(film.shell("make -q -f \"$script\"").exitCode, 0);
  EXPECT_EQ(film.shell("sleep 0.01; touch tiny.toml; make -q -f \"$script\"").exitCode, 1);
  // The scene still has the same meaning, so the film stays and counts as newer.
  const ShellResult again =
      film.shell("cp -p film.mp4 first.mp4; make -j 2 -f \"$script\" && cmp first.mp4 film.mp4");
  EXPECT_EQ(again.exitCode, 0) << again.out;
  EXPECT_THAT(again.out, HasSubstr("film.mp4 is complete: nothing is left to make for shard 3/3"));
  EXPECT_EQ(film.shell("make -q -f \"$script\"").exitCode, 0);
}

// The lines run in reverse order, and one of them twice, because its first run is killed.
TEST(Lines, AreIndependentAndGiveTheBytesOfALocalRun) {
  SubmittedFilm film;
  film.writeScript("lines", "--program " + film.standIn());
  film.breakShard(2, true);
  const ShellResult made = film.shell(
      "set -e; cd /\n"
      "mapfile -t lines <\"$script\"\n"
      "[[ ${#lines[@]} == 4 ]]\n"
      "for k in 2 1 0; do bash -c \"${lines[k]}\" || bash -c \"${lines[k]}\"; done\n"
      "bash -c \"${lines[3]}\"");
  EXPECT_EQ(made.exitCode, 0) << made.out;
  EXPECT_TRUE(film.died());
  film.expectTheBytesOfALocalRun(made.out);
}

// Oracle of each film: `render -D` of its value.
TEST(Series, HasTheFilmsOfALocalRun) {
  const SubmittedFilm film(SubmittedFilm::kFolderForMake);
  for (const std::string engine : {"parallel", "make", "lines"}) {
    if (engine != "lines" && !isInstalled(engine)) continue;
    const std::string run = engine == "parallel" ? "bash \"$script\""
                            : engine == "make"   ? "make -j 2 -f \"$script\""
                                                 : "while read -r line; do bash -c \"$line\"; done <\"$script\"";
    const ShellResult made = film.shell(
        "set -e; rm -rf films; mkdir films\n"
        "$poinsot submit tiny.toml --series -D 'time.start=0..2 s:3' -o 'films/{value}.mp4' --size 64x36 --shards "
        "2 "
        "--engine " +
        engine + " >\"$script\"\n" + run +
        "\n"
        "for k in 0 1 2; do\n"
        "  $poinsot render tiny.toml -D \"time.start=$k s\" -o local.mp4 --size 64x36 --reproducible --quiet\n"
        "  cmp local.mp4 films/$k.mp4\n"
        "done");
    EXPECT_EQ(made.exitCode, 0) << engine << made.out;
  }
}

}  // namespace
}  // namespace poinsot::faults
