// SPDX-License-Identifier: Apache-2.0
// Who makes which frames, and where, does not change a byte.
#include <gmock/gmock.h>

#include <map>

#include "faults/tiny_film.h"

namespace poinsot::faults {
namespace {

using Files = std::vector<std::pair<std::string, std::string>>;

/// What one process makes of it in the profile of clusters.
const Files& reproducible(const Output& output) {
  static std::map<std::string, Files> made;
  const auto [place, isNew] = made.try_emplace(output.name);
  if (isNew) {
    const ScratchFolder folder;
    folder.put("tiny.toml", kTinyScene);
    EXPECT_EQ(run(folder, renderArguments(output, {"--reproducible"})).exitCode, 0);
    place->second = filesOf(folder.path());
  }
  return place->second;
}

class Shards : public testing::TestWithParam<int> {
 protected:
  void expectSameBytes(const Output& output) const {
    const ScratchFolder folder;
    folder.put("tiny.toml", kTinyScene);
    for (int k = GetParam(); k >= 1; --k) {
      const std::string shard = std::to_string(k) + "/" + std::to_string(GetParam());
      const RunResult made = run(folder, renderArguments(output, {"--shard", shard}));
      ASSERT_EQ(made.exitCode, 0) << made.err;
      EXPECT_EQ(run(folder, {"status", output.name}).exitCode, k == 1 ? 0 : 1) << k;
    }
    const RunResult joined = run(folder, {"assemble", output.name});
    ASSERT_EQ(joined.exitCode, 0) << joined.err;
    EXPECT_EQ(filesOf(folder.path()), reproducible(output));
    EXPECT_EQ(namesIn(folder.path()).size(), reproducible(output).size() + 1);
  }
};

TEST_P(Shards, OfAFilmMakeItsBytes) { expectSameBytes(kFilm); }
TEST_P(Shards, OfASequenceMakeItsBytes) { expectSameBytes(kSequence); }

// Of 7, one has nothing to do: there are six segments.
INSTANTIATE_TEST_SUITE_P(Of, Shards, testing::Values(1, 2, 3, 7), testing::PrintToStringParamName());

TEST(Shards, AreJoinedToWhatTheyWereMadeFor) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  for (const Output* output : {&kFilm, &kSequence})
    EXPECT_EQ(run(folder, renderArguments(*output, {"--shard", "1/1"})).exitCode, 0);
  const RunResult kind = run(folder, {"assemble", kFilm.name, "-o", "other.webm"});
  EXPECT_EQ(kind.exitCode, 2);
  EXPECT_EQ(kind.err, "poinsot: error: -o other.webm: the segments are those of a .mp4\n");
  const RunResult frames = run(folder, {"assemble", kSequence.name, "-o", "other.mp4"});
  EXPECT_EQ(frames.exitCode, 2);
  EXPECT_EQ(frames.err, "poinsot: error: -o names another place for a film; frames stay where they are\n");
}

TEST(Shards, TellWhichHaveWorkLeft) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  ASSERT_EQ(run(folder, renderArguments(kFilm, {"--shard", "2/5"})).exitCode, 0);
  const RunResult open = run(folder, {"status", "t.mp4", "--shards"});
  EXPECT_EQ(open.exitCode, 1);
  EXPECT_EQ(open.out, "1,3-5\n");
  EXPECT_EQ(run(folder, renderArguments(kFilm, {"--shard", "6/5"})).exitCode, 2);
  EXPECT_EQ(run(folder, renderArguments(kFilm, {"--shard", "0/5"})).exitCode, 2);
  EXPECT_EQ(run(folder, renderArguments(kFilm, {"--shard", "1"})).exitCode, 2);
}

// Two at once, as on two machines with one disk.
TEST(Shards, WorkSideBySide) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  ProgramRun one(folder, renderArguments(kFilm, {"--shard", "1/2"}));
  ProgramRun two(folder, renderArguments(kFilm, {"--shard", "2/2", "--quiet"}));
  EXPECT_EQ(one.wait().exitCode, 0);
  EXPECT_EQ(two.wait().exitCode, 0);
  EXPECT_EQ(run(folder, {"assemble", "t.mp4"}).exitCode, 0);
  EXPECT_EQ(filesOf(folder.path()), reproducible(kFilm));
}

struct Surroundings {
  const char* name;
  std::vector<std::string> environment, arguments;
};

class Anywhere : public testing::TestWithParam<Surroundings> {};

TEST_P(Anywhere, TheBytesAreTheSame) {
  for (const Output& output : {kFilm, kSequence}) {
    const ScratchFolder folder;
    folder.put("tiny.toml", kTinyScene);
    const RunResult made =
        run(folder, renderArguments(output, GetParam().arguments), Stdout::kFile, GetParam().environment);
    ASSERT_EQ(made.exitCode, 0) << made.err;
    EXPECT_EQ(filesOf(folder.path()), undisturbed(output)) << output.name;
  }
}

INSTANTIATE_TEST_SUITE_P(
    In, Anywhere,
    testing::Values(Surroundings{"TwoWorkers", {}, {"-j", "2"}}, Surroundings{"FourWorkers", {}, {"-j", "4"}},
                    Surroundings{"RasterThreads", {"LP_NUM_THREADS=7"}, {}},
                    Surroundings{"NoRasterThreads", {"LP_NUM_THREADS=0"}, {"-j", "2"}},
                    Surroundings{"AnotherBackEnd", {}, {"--backend", "egl"}},
                    Surroundings{
                        "AnotherPlace", {"TZ=Pacific/Kiritimati", "HOME=/nonexistent", "USER=nobody"}, {}},
                    Surroundings{"AnotherLanguage", {"LC_ALL=de_DE.UTF-8", "LANGUAGE=de"}, {}}),
    [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace poinsot::faults
