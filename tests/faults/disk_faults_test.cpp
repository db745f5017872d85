// SPDX-License-Identifier: Apache-2.0
// A disk is full, broken or slow at every call. Exit code 0 means that every promised byte is on disk.
#include <gmock/gmock.h>

#include <cerrno>
#include <cstring>

#include "faults/tiny_film.h"

namespace poinsot::faults {
namespace {

using testing::HasSubstr;

std::string errnoText(int why) { return std::to_string(why); }

class DiskFault : public testing::TestWithParam<Fault> {
 protected:
  /// Fails the n-th call, for every n until there is no such call. After every third failure, the render is
  /// resumed.
  void failEach(const Output& output) const {
    for (int n = 1;; ++n) {
      const ScratchFolder folder;
      folder.put("tiny.toml", kTinyScene);
      const RunResult result =
          run(folder, renderArguments(output), Stdout::kFile, environmentOf(GetParam(), n, folder));
      if (!struck(folder)) {
        EXPECT_EQ(result.exitCode, 0) << result.err;
        EXPECT_GT(n, 1) << "there is no such call";
        return;
      }
      const std::string where = "(call " + std::to_string(n) + ")";
      EXPECT_EQ(result.exitCode, 4) << result.err << where;
      EXPECT_THAT(result.err, HasSubstr(std::strerror(std::stoi(GetParam().kind)))) << where;
      expectAllWhole(folder.path(), where);
      if (n % 3 != 1) continue;
      const RunResult again = run(folder, renderArguments(output, {"--resume"}));
      ASSERT_EQ(again.exitCode, 0) << again.err << where;
      EXPECT_EQ(filesOf(folder.path()), undisturbed(output)) << where;
    }
  }
};

TEST_P(DiskFault, ExitsWith4WhileAFilmIsWritten) { failEach(kShortFilm); }
TEST_P(DiskFault, ExitsWith4WhileASequenceIsWritten) { failEach(kShortSequence); }

INSTANTIATE_TEST_SUITE_P(
    Each, DiskFault,
    testing::Values(Fault{"write", "worker", errnoText(ENOSPC), true}, Fault{"open", "worker", errnoText(EMFILE)},
                    Fault{"fsync", "worker", errnoText(EIO)}, Fault{"close", "worker", errnoText(EIO)},
                    Fault{"rename", "worker", errnoText(EACCES)},
                    Fault{"write", "parent", errnoText(ENOSPC), true}, Fault{"open", "parent", errnoText(EDQUOT)},
                    Fault{"fsync", "parent", errnoText(EIO)}, Fault{"close", "parent", errnoText(EIO)},
                    Fault{"rename", "parent", errnoText(EXDEV)}, Fault{"mkdir", "parent", errnoText(EROFS)}),
    callOf);

TEST(LostWorkerMessage, IsReportedAsAnError) {
  for (const std::string role : {"parent", "worker"})
    for (int n = 1;; ++n) {
      const ScratchFolder folder;
      folder.put("tiny.toml", kTinyScene);
      const Fault fault{"tell", role, errnoText(ENOSPC)};
      const RunResult result =
          run(folder, renderArguments(kShortFilm), Stdout::kFile, environmentOf(fault, n, folder));
      if (!struck(folder)) {
        EXPECT_EQ(result.exitCode, 0) << result.err;
        EXPECT_GT(n, 2) << "the job, and segments";
        break;
      }
      EXPECT_EQ(result.exitCode, 3) << role << n << result.err;
      EXPECT_THAT(result.err, role == "parent"
                                  ? HasSubstr("a message to a worker process could not be sent: No space")
                                  : HasSubstr("worker"))
          << n;
      EXPECT_FALSE(std::filesystem::exists(folder / "t.mp4"));
    }
}

// Harmless events: a signal between two bytes, and a write that takes only part of the data.
class DiskTrouble : public testing::TestWithParam<Fault> {};

TEST_P(DiskTrouble, ChangesNoOutput) {
  for (const Output& output : {kShortFilm, kShortSequence})
    for (int n = 1; n <= 3; ++n) {
      const ScratchFolder folder;
      folder.put("tiny.toml", kTinyScene);
      const RunResult result =
          run(folder, renderArguments(output), Stdout::kFile, environmentOf(GetParam(), n, folder));
      EXPECT_EQ(result.exitCode, 0) << result.err;
      EXPECT_TRUE(struck(folder) || n > 1);
      EXPECT_EQ(filesOf(folder.path()), undisturbed(output));
    }
}

INSTANTIATE_TEST_SUITE_P(Short, DiskTrouble,
                         testing::Values(Fault{"write", "worker", "short", true},
                                         Fault{"write", "parent", "short", true}),
                         callOf);
INSTANTIATE_TEST_SUITE_P(Interrupted, DiskTrouble,
                         testing::Values(Fault{"write", "worker", errnoText(EINTR)},
                                         Fault{"write", "parent", errnoText(EINTR)},
                                         Fault{"fsync", "worker", errnoText(EINTR)}),
                         callOf);

}  // namespace
}  // namespace poinsot::faults
