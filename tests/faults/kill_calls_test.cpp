// SPDX-License-Identifier: Apache-2.0
// If a render is killed at a call that changes the disk, another render can resume from the files left.
#include <gmock/gmock.h>
#include <signal.h>

#include "faults/tiny_film.h"

namespace poinsot::faults {
namespace {

constexpr int kKilled = 1000 + SIGKILL;

class KillAtEachCall : public testing::TestWithParam<Fault> {};

TEST_P(KillAtEachCall, LeavesARenderThatCanBeResumed) {
  for (int n = 1;; ++n) {
    const ScratchFolder folder;
    folder.put("tiny.toml", kTinyScene);
    const RunResult first =
        run(folder, renderArguments(kShortFilm), Stdout::kFile, environmentOf(GetParam(), n, folder));
    if (!struck(folder)) {
      EXPECT_EQ(first.exitCode, 0);
      EXPECT_GT(n, 1) << "there is no such call";
      return;
    }
    ASSERT_EQ(first.exitCode, kKilled);
    const std::string where = "(killed at call " + std::to_string(n) + ")";
    expectAllWhole(folder.path(), where);
    const RunResult again = run(folder, renderArguments(kShortFilm, {"--resume"}));
    ASSERT_EQ(again.exitCode, 0) << again.err << where;
    EXPECT_EQ(filesOf(folder.path()), undisturbed(kShortFilm)) << where;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, KillAtEachCall,
                         testing::Values(Fault{"open", "worker", "kill"}, Fault{"write", "worker", "kill"},
                                         Fault{"fsync", "worker", "kill"}, Fault{"close", "worker", "kill"},
                                         Fault{"rename", "worker", "kill"}, Fault{"open", "parent", "kill"},
                                         Fault{"write", "parent", "kill"}, Fault{"fsync", "parent", "kill"},
                                         Fault{"rename", "parent", "kill"}, Fault{"mkdir", "parent", "kill"}),
                         callOf);

}  // namespace
}  // namespace poinsot::faults
