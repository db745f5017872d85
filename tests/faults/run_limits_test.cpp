// SPDX-License-Identifier: Apache-2.0
// A run that reaches its time limit or its output limit exits with 2 and loses nothing.
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

  void expectGoesOn(const Output& output) {
    const RunResult resumed = run(folder_, renderArguments(output, {"--resume", "--progress", "plain"}));
    EXPECT_EQ(resumed.exitCode, 0) << resumed.err;
    EXPECT_THAT(resumed.err, HasSubstr("already existed"));
    EXPECT_EQ(filesOf(folder_.path()), undisturbed(output));
  }

  const ScratchFolder folder_;
};

// On any machine, the film takes longer than the limit: 3.3 s at 730 frames per second.
TEST_F(RunLimits, StopAFilmAtItsTimeLimit) {
  const Output film{"t.mp4", 240, "160x90", 10};
  RunResult ended;
  const double took_s = seconds([&] { ended = run(folder_, renderArguments(film, {"--max-seconds", "1"})); });
  EXPECT_EQ(ended.exitCode, 2) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("stopped after 1 s, as set by --max-seconds"));
  EXPECT_THAT(ended.err,
              ContainsRegex("[0-9]+ of 2400 frames are kept; to continue, run the same command with --resume"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "t.mp4"));
  EXPECT_GE(took_s, 1);
  EXPECT_LE(took_s, 3);  // measured 1.1; the program gives a worker 1.5 s to end
  expectGoesOn(film);
}

// The limit allows 1e9 steps, and nothing interrupts the integration.
TEST_F(RunLimits, StopALongIntegrationAtItsTimeLimit) {
  const double took_s = seconds([&] {
    const RunResult ended =
        run(folder_, {"check", "tiny.toml", "--max-seconds", "1", "--limit", "steps=1000000000", "-D",
                      "motion.gravity.mgr_body=[0,0,1e4]", "-D", "time.speed=1e5", "-D", "time.duration=100"});
    EXPECT_EQ(ended.exitCode, 2) << ended.err;
    EXPECT_EQ(ended.err, "poinsot: error: stopped after 1 s, as set by --max-seconds\n");
  });
  EXPECT_GE(took_s, 1);
  EXPECT_LE(took_s, 2);
}

TEST_F(RunLimits, StopATrajectoryAtItsTimeLimit) {
  const RunResult ended = run(folder_, {"trajectory", "tiny.toml", "--max-seconds", "1", "--rate", "10000000",
                                        "-o", "t.csv", "-D", "time.duration=10"});
  EXPECT_EQ(ended.exitCode, 2) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("stopped after 1 s"));
  EXPECT_EQ(namesIn(folder_.path()), std::vector<std::string>{"tiny.toml"});
}

TEST_F(RunLimits, StopAtTheOutputLimit) {
  for (const Output& output : {kFilm, kSequence}) {
    const RunResult ended = run(folder_, renderArguments(output, {"--limit", "output=3000"}));
    EXPECT_EQ(ended.exitCode, 2) << ended.err;
    EXPECT_THAT(ended.err, ContainsRegex("[0-9]+ bytes are written after [0-9]+ of 18 frames; a run may write "
                                         "3000 bytes; --limit output=N raises the limit"));
    EXPECT_THAT(ended.err, HasSubstr("to continue, run the same command with --resume"));
    expectGoesOn(output);
    for (const auto& [name, bytes] : undisturbed(output)) std::filesystem::remove(folder_ / name);
  }
}

}  // namespace
}  // namespace poinsot::faults
