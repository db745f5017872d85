// SPDX-License-Identifier: Apache-2.0
// If a render is killed at any moment, no broken file has a final name, and another render resumes to the same
// bytes.
#include <gmock/gmock.h>
#include <signal.h>
#include <unistd.h>

#include <random>
#include <regex>

#include "faults/tiny_film.h"

namespace poinsot::faults {
namespace {

using testing::Each;
using testing::Not;
using testing::StartsWith;

constexpr int kKilled = 1000 + SIGKILL;

int reusedFrames(const std::string& err) {
  std::smatch found;
  return std::regex_search(err, found, std::regex("([0-9]+) of them already existed")) ? std::stoi(found[1]) : 0;
}

int framesDone(const std::string& err) {
  int done = 0;
  const std::regex line("\"done\":([0-9]+)");
  for (std::sregex_iterator at(err.begin(), err.end(), line), end; at != end; ++at) done = std::stoi((*at)[1]);
  return done;
}

class Kill : public testing::TestWithParam<Output> {};

// Tries 20 moments, spread evenly at random over a run with a fixed seed. The whole process group dies, as when a
// node of a cluster is lost. A film keeps whole segments and a sequence keeps whole frames; two are in progress.
TEST_P(Kill, LosesAtMostOneSegmentPerWorker) {
  const Output& output = GetParam();
  std::mt19937 random(20261121);
  std::uniform_real_distribution<double> moment_s(0.02, secondsOfARun(output));
  int midway = 0;
  for (int i = 0; i < 20; ++i) {
    const ScratchFolder folder;
    folder.put("tiny.toml", kTinyScene);
    const double at_s = moment_s(random);
    ProgramRun running(folder, renderArguments(output, {"-j", "2"}));
    usleep(static_cast<useconds_t>(1e6 * at_s));
    kill(-running.pid(), SIGKILL);
    const RunResult first = running.wait();
    const int done = first.exitCode == 0 ? 0 : framesDone(first.err);
    midway += done > 0 ? 1 : 0;
    const std::string where = "(killed after " + std::to_string(at_s) + " s)";
    expectAllWhole(folder.path(), where);
    const RunResult again = run(folder, renderArguments(output, {"--resume", "--progress", "plain"}));
    ASSERT_EQ(again.exitCode, 0) << again.err << where;
    EXPECT_EQ(filesOf(folder.path()), undisturbed(output)) << where;
    EXPECT_GE(reusedFrames(again.err), done - 2 * (output.isFilm() ? output.segmentFrames : 1)) << where;
    EXPECT_THAT(namesIn(folder.path()), Each(Not(StartsWith(".")))) << where;
  }
  EXPECT_GE(midway, 5);  // otherwise, the moments were badly chosen
}

INSTANTIATE_TEST_SUITE_P(Each, Kill, testing::Values(kLongFilm, kLongSequence), kindOf);

// An earlier complete film stays until the new film is complete.
TEST(KilledRender, KeepsTheOldFilmUnchanged) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  ASSERT_EQ(run(folder, renderArguments(kFilm, {"-D", "output.crf=40"})).exitCode, 0);
  const std::string old = bytesOf(folder / "t.mp4");
  for (const char* call : {"rename", "fsync"}) {
    const auto environment = environmentOf({call, "parent", "kill"}, 2, folder);
    EXPECT_EQ(run(folder, renderArguments(kFilm), Stdout::kFile, environment).exitCode, kKilled) << call;
    EXPECT_TRUE(struck(folder));
    EXPECT_EQ(bytesOf(folder / "t.mp4"), old) << call;
  }
  EXPECT_EQ(run(folder, renderArguments(kFilm, {"--resume"})).exitCode, 0);
  EXPECT_EQ(filesOf(folder.path()), undisturbed(kFilm));
}

}  // namespace
}  // namespace poinsot::faults
