// SPDX-License-Identifier: Apache-2.0
// A run that comes to the end of its time, or of what it may write, ends with 2 and loses nothing.
#include <gmock/gmock.h>

#include <chrono>

#include "faults/tiny_film.h"
#include "support/shell_run.h"

namespace poinsot::faults {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

class RunLimits : public testing::Test {
 protected:
  RunLimits() { folder_.put("tiny.toml", kTinyScene); }

  /// Goes on with what was left, to the same bytes as if nothing had been.
  void expectGoesOn(const Output& output) {
    const RunResult resumed = run(folder_, renderArguments(output, {"--resume", "--progress", "plain"}));
    EXPECT_EQ(resumed.exitCode, 0) << resumed.err;
    EXPECT_THAT(resumed.err, HasSubstr("were there already"));
    EXPECT_EQ(filesOf(folder_.path()), undisturbed(output));
  }

  const ScratchFolder folder_;
};

// Of a film that takes longer on any machine: 3.3 s where frames come at 730 a second.
TEST_F(RunLimits, TheTimeIsOver) {
  const Output film{"t.mp4", 240, "160x90", 10};
  RunResult ended;
  const double took_s = seconds([&] { ended = run(folder_, renderArguments(film, {"--max-seconds", "1"})); });
  EXPECT_EQ(ended.exitCode, 2) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("stopped after 1 s, as --max-seconds says"));
  EXPECT_THAT(ended.err, ContainsRegex("[0-9]+ of 2400 frames are kept; the same command with --resume"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "t.mp4"));
  EXPECT_GE(took_s, 1);
  EXPECT_LE(took_s, 3);  // measured 1.1; 1.5 s of patience with a worker
  expectGoesOn(film);
}

// Of 2e9 allowed steps, and nobody who looks for an interrupt.
TEST_F(RunLimits, TheTimeIsOverInALongComputation) {
  const double took_s = seconds([&] {
    const RunResult ended =
        run(folder_, {"check", "tiny.toml", "--max-seconds", "1", "--limit", "steps=1000000000", "-D",
                      "motion.gravity.mgr_body=[0,0,1e4]", "-D", "time.speed=1e5", "-D", "time.duration=100"});
    EXPECT_EQ(ended.exitCode, 2) << ended.err;
    EXPECT_EQ(ended.err, "poinsot: error: stopped after 1 s, as --max-seconds says\n");
  });
  EXPECT_GE(took_s, 1);
  EXPECT_LE(took_s, 2);
}

TEST_F(RunLimits, TheTimeIsOverBeforeATrajectory) {
  const RunResult ended = run(folder_, {"trajectory", "tiny.toml", "--max-seconds", "1", "--rate", "10000000",
                                        "-o", "t.csv", "-D", "time.duration=10"});
  EXPECT_EQ(ended.exitCode, 2) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("stopped after 1 s"));
  EXPECT_EQ(namesIn(folder_.path()), std::vector<std::string>{"tiny.toml"});
}

TEST_F(RunLimits, TooMuchIsWritten) {
  for (const Output& output : {kFilm, kSequence}) {
    const RunResult ended = run(folder_, renderArguments(output, {"--limit", "output=3000"}));
    EXPECT_EQ(ended.exitCode, 2) << ended.err;
    EXPECT_THAT(ended.err,
                ContainsRegex("[0-9]+ bytes are written after [0-9]+ of 18 frames; a run may write 3000 "
                              "bytes; --limit output=N raises that"));
    EXPECT_THAT(ended.err, HasSubstr("with --resume goes on from there"));
    expectGoesOn(output);
    for (const auto& [name, bytes] : undisturbed(output)) std::filesystem::remove(folder_ / name);
  }
}

}  // namespace
}  // namespace poinsot::faults
