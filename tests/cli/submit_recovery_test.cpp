// SPDX-License-Identifier: Apache-2.0
// Runs scripts of submit again, with a stand-in for Slurm and the real program.
#include <gmock/gmock.h>

#include "cli/submit_fixture.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int kShards = 3;

class SubmitAgain : public Submit {
 protected:
  SubmitAgain() {
    // Stand-in for sbatch: records the requested tasks, or the joining, and whether the joining waits for the
    // tasks.
    executable(
        "sbatch",
        "for word; do\n"
        "  case $word in --array=*) what=\"tasks ${word#*=}\" ;; --dependency=*) what='joined after' ;; esac\n"
        "done\n"
        "cat >/dev/null\n"
        "echo \"${what-joined}\" >>\"${0%/*}/asked\"\n"
        "echo 7\n");
    std::ofstream(home() / "-it's.toml")
        << "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 2, 0.1]\n[time]\nduration = 1\n"
           "[show]\nellipsoid = false\nplane = false\nherpolhode = false\npolhode = false\ncontact = false\n"
           "L = false\nomega = false\nprincipal_axes = false\n";
    const ShellResult printed = real(std::string(kPrint) + kFilm + "--shards 3 >../script");
    EXPECT_EQ(printed.exitCode, 0) << printed.out;
  }

  /// Runs commands without POINSOT and with no poinsot on the PATH.
  ShellResult real(const std::string& script) const { return shell(script, {"POINSOT="}); }

  void makeAllShards() const {
    for (int k = 1; k <= kShards; ++k) {
      const ShellResult made =
          real(POINSOT_PROGRAM " render ./-it\\'s.toml " + kFilm + "--shard " + std::to_string(k) + "/3");
      ASSERT_EQ(made.exitCode, 0) << made.out;
    }
  }

  /// Returns the files of a shard's segments: segment i belongs to shard i modulo 3.
  std::vector<fs::path> segmentsOf(int shard) const {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(work())) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with("segment-") && std::stoi(name.substr(8, 9)) % kShards == shard - 1)
        files.push_back(entry.path());
    }
    return files;
  }

  /// Runs the script. @returns the submitted jobs
  std::string submitted(int exitCode = 0) const {
    const ShellResult run = real("cd / && bash \"$OLDPWD/../script\"");
    EXPECT_EQ(run.exitCode, exitCode) << run.out;
    return left("asked");
  }

  fs::path film() const { return home() / "f.mp4"; }
  fs::path work() const { return home() / ".f.mp4.poinsot"; }

  const std::string kFilm = "-o f.mp4 --frames 0-5 --segment 1 --size 64x36 ";
};

// Tries each set of finished shards, from none to all. kLeft has the other shards as Slurm takes them in --array;
// the bits of its index are the finished shards.
TEST_F(SubmitAgain, SubmitsUnfinishedShardsAndTheJoinJob) {
  const char* const kLeft[] = {"1-3", "2-3", "1,3", "3", "1-2", "2", "1", ""};
  EXPECT_EQ(submitted(), "tasks 1-3\njoined after\n") << "no task ever began";
  makeAllShards();
  fs::rename(work(), scratch_ / "whole");
  for (int done = 0; done < 8; ++done) {
    fs::copy(scratch_ / "whole", work(), fs::copy_options::recursive);
    for (int k = 1; k <= kShards; ++k)
      if ((done >> (k - 1) & 1) == 0)
        for (const fs::path& file : segmentsOf(k)) fs::remove(file);
    const std::string tasks = kLeft[done];
    EXPECT_EQ(submitted(), tasks.empty() ? "joined\n" : "tasks " + tasks + "\njoined after\n") << done;
    EXPECT_FALSE(fs::exists(film()));
    fs::remove_all(work());
  }
  fs::copy(scratch_ / "whole", work(), fs::copy_options::recursive);
  std::ofstream(segmentsOf(2).front(), std::ios::app) << "more";
  EXPECT_EQ(submitted(), "tasks 2\njoined after\n") << "a segment is damaged";
}

TEST_F(SubmitAgain, SubmitsNothingForAFinishedFilmOfTheSameScene) {
  ASSERT_EQ(real(POINSOT_PROGRAM " render ./-it\\'s.toml " + kFilm + "--reproducible").exitCode, 0);
  const ShellResult ready = real("bash ../script");
  EXPECT_EQ(ready.exitCode, 0);
  EXPECT_EQ(ready.out, "poinsot: f.mp4 is complete\n");
  EXPECT_EQ(left("asked"), "");
  std::ofstream(home() / "-it's.toml", std::ios::app) << "labels = false\n";
  EXPECT_EQ(submitted(), "tasks 1-3\njoined after\n");
}

TEST_F(SubmitAgain, FailsIfTheSceneIsInvalidOrTheProgramIsMissing) {
  std::ofstream(home() / "-it's.toml", std::ios::app) << "labls = false\n";
  EXPECT_EQ(submitted(2), "");
  const ShellResult gone = shell("bash ../script", {"POINSOT=/nowhere/poinsot"});
  EXPECT_EQ(gone.exitCode, 127);
  EXPECT_THAT(gone.out, HasSubstr("/nowhere/poinsot"));
  EXPECT_EQ(left("asked"), "");
}

TEST_F(SubmitAgain, SubmitsNamedTasksWithoutRunningTheProgram) {
  for (const std::string tasks : {"2", "1,3", "1-3%1"}) {
    EXPECT_EQ(shell("bash ../script " + tasks, {"POINSOT=/nowhere/poinsot"}).exitCode, 0);
    EXPECT_EQ(left("asked"), "tasks " + tasks + "\njoined after\n");
  }
  EXPECT_EQ(real("bash ../script ''").exitCode, 0);
  EXPECT_EQ(left("asked"), "tasks 1-3\njoined after\n");
}

TEST_F(SubmitAgain, SubmitsNoJoinJobIfSlurmRejectsTheTasks) {
  executable("sbatch", "cat >/dev/null; echo >>\"${0%/*}/asked\"; exit 1\n");
  EXPECT_EQ(submitted(1), "\n");
}

}  // namespace
}  // namespace poinsot
