// SPDX-License-Identifier: Apache-2.0
// If a signal asks a render to end at any moment, it ends at once and prints how to go on. Another render resumes
// to the same bytes.
#include <gmock/gmock.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <random>

#include "faults/tiny_film.h"

namespace poinsot::faults {
namespace {

using std::chrono::steady_clock;
using testing::AnyOf;
using testing::HasSubstr;

double secondsSince(steady_clock::time_point start) {
  return std::chrono::duration<double>(steady_clock::now() - start).count();
}

class Signal : public testing::TestWithParam<int> {};

// Tries seven moments of a run for each of the three signals, with a fixed seed.
TEST_P(Signal, EndsARenderInTwoSecondsAndAllowsResume) {
  std::mt19937 random(static_cast<unsigned>(20261121 + GetParam()));
  std::uniform_real_distribution<double> moment_s(0.05, secondsOfARun(kLongFilm));
  int midway = 0;
  for (int i = 0; i < 7; ++i) {
    const ScratchFolder folder;
    folder.put("tiny.toml", kTinyScene);
    ProgramRun running(folder, renderArguments(kLongFilm, {"-j", "2"}));
    usleep(static_cast<useconds_t>(1e6 * moment_s(random)));
    const auto sent = steady_clock::now();
    running.signal(GetParam());
    const RunResult first = running.wait();
    EXPECT_LT(secondsSince(sent), 2.0);
    // Before the program handles the signal, it may be killed outright, which a shell also reports as 128 +
    // signal. No file exists then.
    const bool begun = filesOf(folder.path()).size() > 1;
    const int unheard = begun ? 0 : 1000 + GetParam();
    EXPECT_THAT(first.exitCode, AnyOf(128 + GetParam(), 0, unheard));
    if (first.err.find("frames are kept") != std::string::npos) ++midway;
    expectAllWhole(folder.path(), "after a signal");
    ASSERT_EQ(run(folder, renderArguments(kLongFilm, {"--resume"})).exitCode, 0);
    EXPECT_EQ(filesOf(folder.path()), undisturbed(kLongFilm));
  }
  EXPECT_GE(midway, 2);  // otherwise, the moments were badly chosen
}

// 30000 s under a torque take a quarter of a minute.
TEST(SignalWhileIntegrating, EndsTheProgramInASecond) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  ProgramRun running(folder, {"trajectory", "tiny.toml", "-D", "motion.torque.body=[0.1,0.2,0.3]", "--at=3e4"});
  usleep(1'000'000);
  const auto sent = steady_clock::now();
  running.signal(SIGINT);
  EXPECT_EQ(running.wait().exitCode, 128 + SIGINT);
  EXPECT_LT(secondsSince(sent), 1.0);  // measured 0.05
}

INSTANTIATE_TEST_SUITE_P(Each, Signal, testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& each) { return std::string(sigabbrev_np(each.param)); });

}  // namespace
}  // namespace poinsot::faults
