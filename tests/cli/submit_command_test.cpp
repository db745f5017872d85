// SPDX-License-Identifier: Apache-2.0
// Tests the scripts of submit with stand-ins for Slurm and for the program. tests/faults runs the real ones.
#include <gmock/gmock.h>

#include "cli/submit_fixture.h"

namespace poinsot {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class SubmitScript : public Submit {
 protected:
  SubmitScript() {
    // Stand-in for the program: records its arguments, one per line, with control characters as bash quotes them.
    // All shards have work left.
    executable("poinsot",
               "[[ $* == *' --shards-left '* ]] && { echo \"1-${@: -1}\"; exit 1; }\n"
               "for word; do printf '%q\\n' \"$word\"; done >>\"${0%/*}/words\"\n");
    // Stand-in for sbatch: runs its script at once for each number of an array, and returns a job number.
    // Variables of the shell are not passed on, as with --export=NONE.
    executable("sbatch",
               "here=${0%/*}\n"
               "printf '%q\\n' \"$@\" >>\"$here/asked\"\n"
               "cat >\"$here/job\"\n"
               "for word; do [[ $word == --array=1-* ]] && last=${word#--array=1-}; done\n"
               "for ((k = 1; k <= ${last:-1}; ++k)); do\n"
               "  cd / && env -i SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=$k bash \"$here/job\" >&2 || exit 1\n"
               "done\n"
               "echo '7;cluster'\n");
  }
};

TEST_F(SubmitScript, PassesAllArgumentsToEachTask) {
  const ShellResult printed =
      shell(std::string(kPrint) +
            "-o $'a \\'$x\\n.mp4' -D 'time.duration=2 s' -D 'show.title=\"it'\\''s\"' "
            "-q preview --fps 30 --frames 0-59 --segment 20 --shards 2 -j 3 --force --keep "
            ">../script");
  ASSERT_EQ(printed.exitCode, 0) << printed.out;
  const ShellResult submitted = shell("cd / && bash \"$OLDPWD/../script\"");
  ASSERT_EQ(submitted.exitCode, 0) << submitted.out;
  EXPECT_THAT(submitted.out, HasSubstr("poinsot: tasks 1-2: job 7\n"));
  const auto render = [](int k) {
    return "render\n./-it\\'s.toml\n-o\n$'a \\'$x\\n.mp4'\n-q\npreview\n-D\ntime.duration=2\\ s\n-D\n"
           "show.title=\\\"it\\'s\\\"\n--fps\n30\n--frames\n0-59\n--force\n--segment\n20\n-j\n3\n--shard\n" +
           std::to_string(k) + "/2\n";
  };
  EXPECT_EQ(left("words"), render(1) + render(2) + "assemble\n$'a \\'$x\\n.mp4'\n--force\n--keep\n");
  const std::string asked = left("asked");
  EXPECT_THAT(asked, HasSubstr("--array=1-2\n"));
  EXPECT_THAT(asked, HasSubstr("--dependency=afterok:7\n"));
  EXPECT_THAT(asked, HasSubstr("--job-name=poinsot_a_\\'\\$x_.mp4\n"));  // sacct splits its lists at blanks
  EXPECT_TRUE(std::filesystem::is_directory(home() / "a '$x\n.mp4.tasks"));
}

// Each line is complete: it works in any folder, and without variables of the shell.
TEST_F(SubmitScript, PrintsLinesThatRunByThemselves) {
  const ShellResult printed =
      shell(std::string(kPrint) + "-o f.mp4 --segment 20 --frames 0-59 --shards 2 --engine lines --program " +
            (scratch_ / "poinsot").string() + " >../lines");
  ASSERT_EQ(printed.exitCode, 0) << printed.out;
  EXPECT_EQ(printed.out,
            "poinsot: 2 tasks of about 2 s on 1 CPU with 512 MiB; the last line joins what they made, after them\n");
  const ShellResult ran =
      shell("cd / && while read -r line; do env -i bash -c \"$line\" || exit; done <\"$OLDPWD/../lines\"");
  EXPECT_EQ(ran.exitCode, 0) << ran.out;
  const auto render = [](int k) {
    return "render\n./-it\\'s.toml\n-o\nf.mp4\n--frames\n0-59\n--segment\n20\n-j\n1\n--shard\n" +
           std::to_string(k) + "/2\n";
  };
  EXPECT_EQ(left("words"), render(1) + render(2) + "assemble\nf.mp4\n");
}

/// Returns shell commands that print a script of the engine to ../script and run it.
std::string printedAndRun(const std::string& engine, const std::string& options) {
  const std::string print =
      std::string(kPrint) + "-o f.mp4 --shards 1 --engine " + engine + " " + options + " >../script && ";
  if (engine == "make") return print + "make -f ../script";
  return print + (engine == "lines" ? "while read -r line; do bash -c \"$line\" || exit; done <../script"
                                    : "bash ../script");
}

TEST_F(SubmitScript, RunsTheSetUpLinesBeforeEachTask) {
  for (const std::string engine : {"slurm", "parallel", "make", "lines"}) {
    if (engine != "slurm" && engine != "lines" && !isInstalled(engine)) continue;
    // make rejects the hostile name of the folder.
    if (engine == "make") continue;
    executable(
        "theirs",
        "[[ $* == *' --shards-left '* ]] && { echo 1; exit 1; }\necho \"$1 $2 $SAID\" >>\"${0%/*}/words\"\n");
    const ShellResult ran =
        shell(printedAndRun(engine, "--setup 'SAID=\"it'\\''s\" # a note' --setup 'export SAID' --program '" +
                                        (scratch_ / "theirs").string() + " in-image'"),
              {});
    EXPECT_EQ(ran.exitCode, 0) << engine << ran.out;
    EXPECT_EQ(left("words"), "in-image render it's\nin-image assemble it's\n") << engine << ran.out;
  }
}

TEST_F(SubmitScript, MakesNothingIfASetUpLineFails) {
  for (const std::string engine : {"slurm", "lines"}) {
    EXPECT_NE(shell(printedAndRun(engine, "--setup 'false # a note'")).exitCode, 0) << engine;
    EXPECT_EQ(left("words"), "") << engine;
  }
}

/// Fixture that runs attempts at one task of a printed script with a given program.
class SubmitTask : public Submit {
 protected:
  SubmitTask() {
    executable("sbatch", "[[ -e ${0%/*}/job ]] && cat >/dev/null || cat >\"${0%/*}/job\"\necho 7\n");
    executable("scontrol", "echo \"$@\" >>\"${0%/*}/asked\"; kill $PPID\n");
    EXPECT_EQ(shell(std::string(kPrint) + "-o f.mp4 --retries 2 >../script && bash ../script 1").exitCode, 0);
  }

  /// @param program  script of the program; with --dry-run, the stand-in prints the number of existing frames
  /// @param restarts  how often Slurm has requeued the task, for any reason
  ShellResult attempt(const std::string& program, int restarts, int framesThere = 0) {
    executable("poinsot", "[[ $* == *' --dry-run' ]] && { echo 'f.mp4, shard 1/1: " + std::to_string(framesThere) +
                              " frames already exist'; exit; }\n" + program);
    return shell("export SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=1 SLURM_JOB_ID=9 SLURM_RESTART_COUNT=" +
                 std::to_string(restarts) + "\nbash ../job");
  }

  bool isRequeued() const {
    const std::string asked = left("asked");
    EXPECT_THAT(asked, AnyOf("", "requeue 7_1\n"));
    return !asked.empty();
  }

  void expectFailsForGood(const ShellResult& result, int code) const {
    EXPECT_EQ(result.exitCode, code) << result.out;
    EXPECT_FALSE(isRequeued()) << result.out;
  }
};

TEST_F(SubmitTask, IsRequeuedAsOftenAsRetriesAllows) {
  for (int restarts = 0; restarts < 2; ++restarts) {
    attempt("exit 3\n", restarts);
    EXPECT_TRUE(isRequeued()) << restarts;
  }
  expectFailsForGood(attempt("exit 3\n", 2), 3);
}

// SLURM_RESTART_COUNT includes preemptions. A task that was only preempted has not failed once.
TEST_F(SubmitTask, KeepsItsRetriesAfterPreemption) {
  constexpr int kPreempted = 20;
  for (int failures = 0; failures < 2; ++failures) {
    attempt("exit 3\n", kPreempted + failures);
    EXPECT_TRUE(isRequeued()) << failures;
  }
  expectFailsForGood(attempt("exit 3\n", kPreempted + 2), 3);
}

TEST_F(SubmitTask, RegainsItsRetriesAfterAFinishedSegment) {
  for (int k = 0; k < 10; ++k) {
    attempt("exit 3\n", k, 30 * (k / 2));  // two failures at each segment
    EXPECT_TRUE(isRequeued()) << k;
  }
  expectFailsForGood(attempt("exit 3\n", 10, 30 * 4), 3);
}

TEST_F(SubmitTask, IsNotRequeuedIfItsFailuresCannotBeCounted) {
  std::filesystem::remove_all(home() / "f.mp4.tasks");
  expectFailsForGood(attempt("exit 3\n", 0), 3);
}

TEST_F(SubmitTask, IsNotRequeuedAfterSuccessUsageErrorOrSignal) {
  for (const int code : {0, 2, 129, 130, 143})
    expectFailsForGood(attempt("exit " + std::to_string(code) + "\n", 0), code);
}

// Slurm sends the signal a minute before the time limit. The script stops the program, gives it time to end, and
// requeues the task. The test sends the signal as early as possible, when the task has just started the program.
TEST_F(SubmitTask, StopsAndIsRequeuedBeforeItsTimeLimit) {
  attempt(
      "trap 'sleep 0.2; echo stopped >\"${0%/*}/stopped\"; exit 143' TERM\n"
      "kill -USR1 $PPID\n"
      "for ((k = 0; k < 100; ++k)); do sleep 0.1; done\n",
      0);
  EXPECT_EQ(left("stopped"), "stopped\n");
  EXPECT_TRUE(isRequeued());
}

TEST_F(Submit, PrintsTheSameScriptForTheSameArguments) {
  for (const std::string engine : {"slurm", "parallel"}) {
    const std::string command = std::string(kPrint) + "-o f.mp4 --engine " + engine;
    const ShellResult once = shell(command);
    EXPECT_EQ(once.exitCode, 0) << once.out;
    EXPECT_THAT(once.out, StartsWith("#!/bin/bash\n"));
    EXPECT_EQ(shell(command).out, once.out);
  }
}

TEST(SubmitCommand, PassesOptionBitsToTheTasks) {
  const ScratchFolder folder;
  folder.put("a.toml", kGoodScene);
  const RunResult deep =
      run(folder, {"submit", "a.toml", "-o", "{frame:05}.png", "--bits", "16", "--transparent"});
  EXPECT_EQ(deep.exitCode, 0) << deep.err;
  EXPECT_THAT(deep.out, HasSubstr(" --transparent --bits 16 "));
}

TEST(SubmitCommand, SubmitsASweepAsTheCommandSweep) {
  const ScratchFolder folder;
  folder.put("a.toml", kGoodScene);
  const RunResult grid =
      run(folder, {"submit", "a.toml", "-o", "g.mp4", "-D", "motion.omega_body=[0.1..0.5:3, 10, 0]", "--columns",
                   "3", "--label", "$\\omega_1$"});
  EXPECT_EQ(grid.exitCode, 0) << grid.err;
  EXPECT_THAT(grid.out, HasSubstr(" sweep a.toml -o g.mp4 -D 'motion.omega_body=[0.1..0.5:3, 10, 0]' --columns 3 "
                                  "--label '$\\omega_1$' "));
}

TEST(SubmitCommand, PassesTheViewToTheTasks) {
  const ScratchFolder folder;
  folder.put("a.toml", kGoodScene);
  const RunResult one = run(folder, {"submit", "a.toml", "-o", "a.mp4", "--view", "1"});
  EXPECT_EQ(one.exitCode, 0) << one.err;
  EXPECT_THAT(one.out, HasSubstr(" render a.toml -o a.mp4 --view 1 "));
  const RunResult none = run(folder, {"submit", "a.toml", "-o", "a.mp4", "--view", "2"});
  EXPECT_EQ(none.exitCode, 2);
  EXPECT_THAT(none.err, HasSubstr("--view 2: the scene has 1 view; give 1"));
}

TEST(SubmitCommand, RejectsInvalidRequests) {
  const ScratchFolder folder;
  folder.put("a.toml", kGoodScene);
  folder.put("bad.toml", std::string(kGoodScene) + "[show]\nelipsoid = true\n");
  folder.put("theirs.mp4", "not ours");
  struct Case {
    std::vector<std::string> words;
    int exitCode;
    std::string says;
  };
  const Case cases[] = {
      {{"a.toml", "-o", "a.png"}, 2, "a.png: one picture is made by one process"},
      {{"a.toml", "-o", "a.mp4", "--engine", "cron"}, 2, "--engine"},
      {{"bad.toml", "-o", "a.mp4"}, 2, "bad.toml:11:1: error: show.elipsoid"},
      {{"none.toml", "-o", "a.mp4"}, 2, "none.toml"},
      {{"a.toml", "-o", "a.mp4", "--size", "63x36"}, 2, "width and height must be even"},
      {{"a.toml", "-o", "a.mp4", "--frames", "0-999"}, 2, "the film has frames 0 to"},
      {{"a.toml", "-o", "a.mp4", "--shards", "0"}, 2, "--shards"},
      {{"a.toml", "-o", "a.mp4", "--frame-seconds", "-1"}, 2, "--frame-seconds"},
      {{"a.toml", "-o", "theirs.mp4"}, 4, "theirs.mp4"},
      {{"a.toml", "-o", "missing/a.mp4"}, 4, "missing"},
      {{"a.toml", "-o", "a.mp4", "--columns", "2"},
       2,
       "--columns and --label: need a grid, that is, -D with a range"},
      {{"a.toml", "-o", "a.mp4", "-D", "motion.omega_body=[1..2:2, 0, 0]", "--loop"},
       2,
       "--loop: not possible in a sweep, because each of its motions would change"},
      {{"a.toml", "-o", "a.mp4", "-D", "time.duration=1..2:3"},
       2,
       "a sweep cannot vary time.duration: all cells are in one film"},
  };
  for (const Case& each : cases) {
    std::vector<std::string> words{"submit"};
    words.insert(words.end(), each.words.begin(), each.words.end());
    const RunResult result = run(folder, words);
    EXPECT_EQ(result.exitCode, each.exitCode) << each.says << result.err;
    EXPECT_THAT(result.err, HasSubstr(each.says));
    EXPECT_THAT(result.out, IsEmpty());
  }
}

}  // namespace
}  // namespace poinsot
