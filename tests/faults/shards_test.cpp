// SPDX-License-Identifier: Apache-2.0
// The distribution of frames over shards and machines changes no byte.
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>

#include "faults/tiny_film.h"

namespace poinsot::faults {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

using Files = std::vector<std::pair<std::string, std::string>>;

/// Returns the files that one process makes with --reproducible.
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
      // A film still needs joining, and a sequence still needs its record closed.
      EXPECT_EQ(run(folder, {"status", output.name}).exitCode, 1) << k;
    }
    const RunResult joined = run(folder, {"assemble", output.name});
    ASSERT_EQ(joined.exitCode, 0) << joined.err;
    EXPECT_EQ(filesOf(folder.path()), reproducible(output));
    EXPECT_EQ(namesIn(folder.path()).size(), reproducible(output).size() + 1);
  }
};

TEST_P(Shards, GiveTheBytesOfAFilmRenderedAtOnce) { expectSameBytes(kFilm); }
TEST_P(Shards, GiveTheBytesOfASequenceRenderedAtOnce) { expectSameBytes(kSequence); }

// There are six segments, so one of 7 shards has nothing to do.
INSTANTIATE_TEST_SUITE_P(Each, Shards, testing::Values(1, 2, 3, 7), testing::PrintToStringParamName());

TEST(Shards, AreJoinedOnlyIntoAnOutputOfTheirFormat) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  for (const Output* output : {&kFilm, &kSequence})
    EXPECT_EQ(run(folder, renderArguments(*output, {"--shard", "1/1"})).exitCode, 0);
  const RunResult kind = run(folder, {"assemble", kFilm.name, "-o", "other.webm"});
  EXPECT_EQ(kind.exitCode, 2);
  EXPECT_EQ(kind.err,
            "poinsot: error: -o other.webm: the segments belong to a .mp4 film; choose a name with the same "
            "extension\n");
  const RunResult frames = run(folder, {"assemble", kSequence.name, "-o", "other.mp4"});
  EXPECT_EQ(frames.exitCode, 2);
  EXPECT_EQ(frames.err, "poinsot: error: -o: possible only for a film; numbered frames stay where they are\n");
}

TEST(Shards, ReportUnfinishedShardsInStatus) {
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

TEST(Shards, AreReportedAsDoneButNotJoined) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  ASSERT_EQ(run(folder, renderArguments(kFilm, {"--shard", "1/1"})).exitCode, 0);
  const RunResult made = run(folder, {"status", "t.mp4"});
  EXPECT_EQ(made.exitCode, 1);
  EXPECT_EQ(made.out,
            "t.mp4: 6 segments: 6 done\n"
            "not joined yet; run: poinsot assemble t.mp4\n");
  const RunResult json = run(folder, {"status", "t.mp4", "--json"});
  EXPECT_EQ(json.exitCode, 1);
  const auto told = nlohmann::json::parse(json.out);
  EXPECT_EQ(told.at("complete"), false);
  EXPECT_EQ(told.at("joined"), false);
  EXPECT_EQ(told.at("done").size(), 6u);
  EXPECT_EQ(told.at("shards_to_run"), "");
  const RunResult shards = run(folder, {"status", "t.mp4", "--shards"});
  EXPECT_EQ(shards.exitCode, 1);
  EXPECT_EQ(shards.out, "\n");
}

TEST(Shards, HaveTheSameStatusKeysInJsonWhenFinished) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  const auto status = [&] { return nlohmann::json::parse(run(folder, {"status", "t.mp4", "--json"}).out); };
  ASSERT_EQ(run(folder, renderArguments(kFilm, {"--shard", "1/2"})).exitCode, 0);
  const auto open = status();
  EXPECT_EQ(open.at("frames"), nlohmann::json({0, 17}));
  ASSERT_EQ(run(folder, renderArguments(kFilm, {"--reproducible", "--resume"})).exitCode, 0);
  const auto finished = status();
  EXPECT_EQ(finished.at("complete"), true);
  EXPECT_EQ(finished.at("joined"), true);
  const auto keys = [](const nlohmann::json& json) {
    std::vector<std::string> names;
    for (const auto& [key, value] : json.items()) names.push_back(key);
    return names;
  };
  EXPECT_EQ(keys(finished), keys(open));
}

TEST(Shards, DoNothingIfTheFilmIsComplete) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  ASSERT_EQ(run(folder, renderArguments(kFilm, {"--reproducible"})).exitCode, 0);
  const auto before = namesIn(folder.path());
  const auto written = std::filesystem::last_write_time(folder / "t.mp4");
  for (const std::string shard : {"1/2", "2/2"}) {
    const RunResult made = run(folder, renderArguments(kFilm, {"--shard", shard, "--progress", "plain"}));
    EXPECT_EQ(made.exitCode, 0);
    EXPECT_EQ(made.err, "poinsot: t.mp4 is complete: nothing is left to make for shard " + shard + "\n");
    EXPECT_EQ(namesIn(folder.path()), before);
    EXPECT_EQ(run(folder, {"status", "t.mp4"}).out, "t.mp4: complete\n");
  }
  // The film could belong to an earlier scene, so the exit code is not 0.
  const RunResult joined = run(folder, {"assemble", "t.mp4"});
  EXPECT_EQ(joined.exitCode, 4);
  EXPECT_EQ(joined.err, "poinsot: error: t.mp4: no segments found; the film itself is complete\n");
  EXPECT_EQ(std::filesystem::last_write_time(folder / "t.mp4"), written);
  EXPECT_EQ(filesOf(folder.path()), reproducible(kFilm));
}

nlohmann::json lastProgress(const RunResult& run) {
  const std::string& lines = run.err;
  const std::size_t at = lines.rfind("{\"event\"");
  return at == std::string::npos ? nlohmann::json() : nlohmann::json::parse(lines.substr(at));
}

// 18 frames in segments of 3: of four shards, the first two have two segments each and the others one.
TEST(Shards, ReportProgressAndEstimatesOfTheirOwnFrames) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  for (const auto& [shard, frames] : {std::pair<std::string, int>{"1/4", 6}, {"3/4", 3}}) {
    const std::string own = std::to_string(frames);
    const auto words = renderArguments(kFilm, {"--shard", shard});
    auto dry = words;
    dry.push_back("--dry-run");
    EXPECT_THAT(run(folder, dry).out, StartsWith("t.mp4, shard " + shard + ": " + own + " of 18 frames (0-17), "));
    EXPECT_THAT(run(folder, dry).out, EndsWith(", 0 frames already exist\n"));
    const auto last = lastProgress(run(folder, words));
    EXPECT_EQ(last.at("total"), frames);
    EXPECT_EQ(last.at("done"), frames);
    EXPECT_EQ(last.at("left_s"), 0);
    EXPECT_THAT(run(folder, dry).out, EndsWith(", " + own + " frames already exist\n"));
  }
  const RunResult bar = run(folder, renderArguments(kFilm, {"--shard", "3/4", "--progress", "plain"}));
  EXPECT_THAT(bar.err, HasSubstr("3 of 3 frames (100 %)"));
}

TEST(Shards, AreListedByOptionShardsLeftIfUnfinished) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  const auto left = [&](const std::vector<std::string>& more = {}) {
    auto words = renderArguments(kFilm, {"--shards-left", "4"});
    words.insert(words.end(), more.begin(), more.end());
    const RunResult told = run(folder, words);
    return std::to_string(told.exitCode) + " " + told.out;
  };
  EXPECT_EQ(left(), "1 1-4\n");
  EXPECT_TRUE(filesOf(folder.path()).empty());
  ASSERT_EQ(run(folder, renderArguments(kFilm, {"--shard", "1/2"})).exitCode, 0);
  EXPECT_EQ(left(), "1 2,4\n") << "segments 1, 3 and 5 are those of shards 1 and 3 of 4";
  ASSERT_EQ(run(folder, renderArguments(kFilm, {"--shard", "2/2"})).exitCode, 0);
  EXPECT_EQ(left(), "1 \n");
  EXPECT_EQ(left({"-D", "show.L=true"}), "1 1-4\n") << "of another scene";
  ASSERT_EQ(run(folder, {"assemble", "t.mp4"}).exitCode, 0);
  EXPECT_EQ(left(), "0 ");
  EXPECT_EQ(left({"-D", "show.L=true"}), "1 1-4\n") << "the film is of another scene";
}

// Without a cache, each task of a cluster compiles for seconds.
TEST(Shards, NoteAMissingShaderCache) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  const auto said = [&](const std::vector<std::string>& environment, const std::vector<std::string>& more) {
    auto words = renderArguments(kFilm, more);
    words.push_back("--dry-run");
    return run(folder, words, Stdout::kFile, environment).err;
  };
  const std::vector<std::string> none{"HOME=", "XDG_CACHE_HOME=", "POINSOT_CACHE="}, plain{"--progress", "plain"},
      shard{"--progress", "plain", "--shard", "1/2"};
  const auto note = HasSubstr("note: each shard compiles its shaders again");
  EXPECT_THAT(said(none, shard), note);
  EXPECT_THAT(said({"HOME=/proc/nowhere", "XDG_CACHE_HOME=", "POINSOT_CACHE="}, shard), note);
  EXPECT_EQ(said(none, plain), "");
  EXPECT_EQ(said({"HOME=", "XDG_CACHE_HOME=", "POINSOT_CACHE=off"}, shard), "");
  EXPECT_EQ(said({"HOME=" + folder.path().string(), "XDG_CACHE_HOME=", "POINSOT_CACHE="}, shard), "");
}

TEST(Shards, CanRenderAtTheSameTime) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  ProgramRun one(folder, renderArguments(kFilm, {"--shard", "1/2"}));
  ProgramRun two(folder, renderArguments(kFilm, {"--shard", "2/2", "--quiet"}));
  EXPECT_EQ(one.wait().exitCode, 0);
  EXPECT_EQ(two.wait().exitCode, 0);
  EXPECT_EQ(run(folder, {"assemble", "t.mp4"}).exitCode, 0);
  EXPECT_EQ(filesOf(folder.path()), reproducible(kFilm));
}

/// Environment and arguments of a run. Not even root can make a home folder below a file.
struct Surroundings {
  const char* name;
  std::vector<std::string> environment, arguments;
};

class RenderedOutput : public testing::TestWithParam<Surroundings> {};

TEST_P(RenderedOutput, HasTheSameBytesWithAnyWorkersAndEnvironment) {
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
    Each, RenderedOutput,
    testing::Values(Surroundings{"TwoWorkers", {}, {"-j", "2"}}, Surroundings{"FourWorkers", {}, {"-j", "4"}},
                    Surroundings{"RasterThreads", {"LP_NUM_THREADS=7"}, {}},
                    Surroundings{"NoRasterThreads", {"LP_NUM_THREADS=0"}, {"-j", "2"}},
                    Surroundings{"AnotherBackEnd", {}, {"--backend", "egl"}},
                    Surroundings{
                        "AnotherPlace", {"TZ=Pacific/Kiritimati", "HOME=/dev/null/home", "USER=nobody"}, {}},
                    Surroundings{"AnotherLanguage", {"LC_ALL=de_DE.UTF-8", "LANGUAGE=de"}, {}}),
    [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace poinsot::faults
