// SPDX-License-Identifier: Apache-2.0
// Tests further failures on clusters, other machines, and the example of docs/clusters.md.
#include <gmock/gmock.h>

#include <cstdio>

#include "faults/slurm_fixture.h"
#include "faults/tiny_film.h"

namespace poinsot::faults {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using SlurmNightly = Slurm;

// The job that joins must not wait forever, and the rest can be submitted by itself.
TEST_F(SlurmNightly, SubmitsOnlyTheFailedTaskAgain) {
  film_.writeScript("slurm", "--retries 0");
  film_.breakShard(2, false);
  submit("bash \"$script\"");
  waitForTheEnd();
  EXPECT_TRUE(film_.died());
  EXPECT_FALSE(film_.hasFilm());
  EXPECT_EQ(film_.shell("$poinsot status film.mp4 --shards").out, "2\n");
  film_.repair();
  const Watch watch;
  submit("bash \"$script\"");
  waitForTheEnd();
  std::printf("[ measured ] Slurm %.1f s for one task and the joining\n", watch.seconds());
  expectTheBytesOfALocalRun();
  EXPECT_EQ(film_.shell("ls film.mp4.tasks | grep -c _2.txt").out, "2\n");  // each array has a file of task 2
  EXPECT_EQ(film_.shell("ls film.mp4.tasks | grep -c _1.txt").out, "1\n");
}

TEST_F(SlurmNightly, MakesAllFramesIfANodeIsLost) {
  film_.writeScript("slurm");
  film_.hangShard(2);
  submit("bash \"$script\"");
  waitUntilItHangs();
  const ShellResult lost =
      cluster_->run("scontrol update State=DOWN Reason=lost NodeName=$(squeue -h -t RUNNING -o %N)");
  ASSERT_EQ(lost.exitCode, 0) << lost.out;
  waitForTheEnd();
  expectTheBytesOfALocalRun();
  EXPECT_THAT(cluster_->restarts(SubmittedFilm::kTasks), ElementsAre(0, 1, 0));
}

// Preemption requeues a task as scontrol does. Slurm counts three restarts of this task, which has one retry.
TEST_F(SlurmNightly, DoesNotCountPreemptionAsARetry) {
  film_.writeScript("slurm", "--retries 1");
  film_.hangShard(2);
  submit("bash \"$script\"");
  waitUntilItHangs();
  film_.hangShard(2);
  ASSERT_EQ(cluster_->run("scontrol requeue $(squeue -h -t RUNNING -o %F)_2").exitCode, 0);
  waitUntilItHangs();
  film_.breakShard(2, true);
  ASSERT_EQ(cluster_->run("scontrol requeue $(squeue -h -t RUNNING -o %F)_2").exitCode, 0);
  waitForTheEnd();
  EXPECT_TRUE(film_.died());
  expectTheBytesOfALocalRun();
  EXPECT_THAT(cluster_->restarts(SubmittedFilm::kTasks), ElementsAre(0, 3, 0));
  EXPECT_EQ(film_.shell("cat film.mp4.tasks/*.failures | wc -l").out, "1\n");
}

TEST_F(SlurmNightly, SubmitsAllTasksIfNoneBegan) {
  film_.writeScript("slurm");
  film_.put("tiny.toml", std::string(kTinyScene) + "wrong = 1\n");
  submit("bash \"$script\" 1-3");
  waitForTheEnd();
  EXPECT_FALSE(film_.hasFilm());
  film_.put("tiny.toml", kTinyScene);
  EXPECT_THAT(submit("bash \"$script\""), HasSubstr("poinsot: tasks 1-3: job "));
  waitForTheEnd();
  expectTheBytesOfALocalRun();
}

/// Returns the block of docs/clusters.md that contains `words`.
std::string exampleOfThePage(const std::string& words, const std::string& language = "sh") {
  const std::string page = bytesOf(POINSOT_SOURCE_DIR "/docs/clusters.md"), fence = "```" + language + "\n";
  for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at)) {
    at += fence.size();
    const std::string block = page.substr(at, page.find("```", at) - at);
    if (block.find(words) != std::string::npos) return block;
  }
  ADD_FAILURE() << words;
  return "false";
}

/// Puts a smaller scene in the place of the page's scene. The scene has four segments and therefore at most four
/// tasks.
/// @returns commands that prepare the folder
std::string preparedScene(const SubmittedFilm& film) {
  std::string scene = std::string(kTinyScene) + "[output]\nsize = [64, 36]\n";
  scene.replace(scene.find("fps = 10"), 8, "fps = 60");
  film.put("scenes/football.toml", scene);
  return "mkdir out && ln -s \"$poinsot\" poinsot && set -e\n";
}

/// Returns commands that run an example unchanged.
std::string preparedExample(const SubmittedFilm& film, const std::string& words) {
  return preparedScene(film) + exampleOfThePage(words);
}

void expectFootballFilm(const SubmittedFilm& film) {
  const ShellResult same = film.shell(
      "$poinsot render scenes/football.toml -o local.mp4 --reproducible --quiet && cmp local.mp4 "
      "out/football.mp4");
  EXPECT_EQ(same.exitCode, 0) << same.out;
}

TEST_F(SlurmNightly, RunsTheExampleInTheDocumentation) {
  submit(preparedExample(film_, "--shards 12 > out/football.sh"));
  waitForTheEnd();
  expectFootballFilm(film_);
  EXPECT_THAT(cluster_->restarts(4), ElementsAre(0, 0, 0, 0));
}

class ClustersPage : public testing::TestWithParam<const char*> {};

TEST_P(ClustersPage, ContainsExamplesThatRun) {
  const SubmittedFilm film(SubmittedFilm::kFolderForMake);
  const ShellResult made = film.shell(preparedExample(film, GetParam()));
  EXPECT_EQ(made.exitCode, 0) << made.out;
  expectFootballFilm(film);
}

INSTANTIATE_TEST_SUITE_P(Each, ClustersPage,
                         testing::Values("--engine parallel", "--engine make", "--engine lines", "--shard 1/3"));

TEST(SnakemakeNightly, RunsTheRulesOfTheDocumentation) {
  if (!isInstalled("snakemake")) GTEST_SKIP() << "snakemake is not installed";
  const SubmittedFilm film("films");
  film.put("Snakefile", exampleOfThePage("rule film", "python"));
  const ShellResult made = film.shell(preparedScene(film) + "PATH=$PWD:$PATH HOME=$PWD snakemake --cores 2");
  EXPECT_EQ(made.exitCode, 0) << made.out;
  expectFootballFilm(film);
  EXPECT_THAT(film.shell("PATH=$PWD:$PATH HOME=$PWD snakemake --cores 2").out, HasSubstr("Nothing to be done"));
}

TEST_F(SlurmNightly, MakesASeries) {
  const ShellResult printed = film_.shell(
      "$poinsot submit tiny.toml --series -D 'time.start=0..2 s:3' -o 'f{value}.mp4' --size 64x36 --shards 2 "
      ">\"$script\"");
  ASSERT_EQ(printed.exitCode, 0) << printed.out;
  EXPECT_THAT(submit("bash \"$script\""), HasSubstr("poinsot: tasks 1-2: job "));
  waitForTheEnd();
  const ShellResult same = film_.shell(
      "for k in 0 1 2; do $poinsot render tiny.toml -D \"time.start=$k s\" -o local.mp4 --size 64x36 "
      "--reproducible "
      "--quiet && cmp local.mp4 f$k.mp4 || exit 1; done");
  EXPECT_EQ(same.exitCode, 0) << same.out;
  EXPECT_EQ(submit("bash \"$script\""), "poinsot: all 3 films are complete\n");
}

TEST(ParallelNightly, ContinuesWithTheSameCommandAfterAFailedTask) {
  if (!isInstalled("parallel")) GTEST_SKIP() << "GNU parallel is not installed";
  SubmittedFilm film;
  film.writeScript("parallel", "--retries 1");
  film.breakShard(2, false);
  EXPECT_NE(film.shell("bash \"$script\" --jobs 1", film.broken()).exitCode, 0);
  EXPECT_FALSE(film.hasFilm());
  film.repair();
  const ShellResult again = film.shell("bash \"$script\"", film.broken());
  EXPECT_EQ(again.exitCode, 0) << again.out;
  film.expectTheBytesOfALocalRun(again.out);
}

// Uses a stand-in for ssh, which passes its last arguments to a shell with an empty environment.
TEST(ParallelNightly, RunsTasksOnOtherMachines) {
  if (!isInstalled("parallel")) GTEST_SKIP() << "GNU parallel is not installed";
  SubmittedFilm film;
  film.writeScript("parallel");
  const ShellResult made = film.shell(
      "ssh=$(mktemp -d)/ssh\n"
      "printf '%s\\n' '#!/bin/bash' 'echo \"$1\" >>\"$0.log\"; shift; [[ $1 == -- ]] && shift' "
      "'exec env -i HOME=/tmp PATH=\"$PATH\" SHELL=/bin/bash bash -c \"$*\"' >\"$ssh\"\n"
      "chmod +x \"$ssh\"\n"
      "PARALLEL_SSH=$ssh bash \"$script\" -S 1/one,1/two\n"
      "code=$?\n"
      "sort -u \"$ssh.log\"\n"
      "rm -r -- \"${ssh%/*}\"\n"
      "exit $code");
  EXPECT_EQ(made.exitCode, 0) << made.out;
  EXPECT_THAT(made.out, HasSubstr("one\n"));
  EXPECT_THAT(made.out, HasSubstr("two\n"));
  film.expectTheBytesOfALocalRun(made.out);
}

// A make rule cannot list all pictures, so one mark stands for them.
TEST(MakeNightly, RendersASequenceOnlyOnce) {
  if (!isInstalled("make")) GTEST_SKIP() << "make is not installed";
  const SubmittedFilm film(SubmittedFilm::kFolderForMake);
  const ShellResult made = film.shell(
      "set -e\n"
      "$poinsot submit tiny.toml -o 'cluster/t_{frame:03}.png' --size 64x36 --segment 3 --engine make "
      ">\"$script\"\n"
      "make -f \"$script\" -j 2\n"
      "make -f \"$script\" -q\n"
      "$poinsot render tiny.toml -o 'local/t_{frame:03}.png' --size 64x36 --segment 3 --reproducible\n"
      "[[ -e cluster/t_017.png && ! -e 'cluster/.t_{frame:03}.png.poinsot' ]]\n"
      "diff -r -x '*.tasks' cluster local");
  EXPECT_EQ(made.exitCode, 0) << made.out;
}

}  // namespace
}  // namespace poinsot::faults
