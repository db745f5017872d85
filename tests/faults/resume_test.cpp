// SPDX-License-Identifier: Apache-2.0
// A render that resumes another one makes the bytes of an undisturbed render.
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "faults/tiny_film.h"

namespace poinsot::faults {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

class Resume : public testing::TestWithParam<Output> {
 protected:
  Resume() { folder_.put("tiny.toml", kTinyScene); }

  RunResult render(const std::vector<std::string>& more) const {
    return run(folder_, renderArguments(GetParam(), more));
  }
  auto made() const { return filesOf(folder_.path()); }
  ScratchFolder folder_;
};

TEST_P(Resume, ContinuesAfterAnInterruption) {
  // Ctrl-C arrives while the third segment's record is being written.
  const auto environment = environmentOf({"rename", "worker", "interrupt"}, GetParam().isFilm() ? 6 : 12, folder_);
  const RunResult first = run(folder_, renderArguments(GetParam()), Stdout::kFile, environment);
  EXPECT_TRUE(struck(folder_));
  EXPECT_EQ(first.exitCode, 130);
  EXPECT_THAT(first.err, HasSubstr(" of 18 frames are kept; to continue, run the same command with --resume"));
  const RunResult second = render({"--resume"});
  EXPECT_EQ(second.exitCode, 0) << second.err;
  EXPECT_EQ(made(), undisturbed(GetParam()));
  EXPECT_THAT(namesIn(folder_.path()), testing::Not(testing::Contains(testing::EndsWith(".poinsot"))));
}

TEST_P(Resume, StartsFromTheBeginningIfNothingExists) {
  EXPECT_EQ(render({"--resume"}).exitCode, 0);
  EXPECT_EQ(made(), undisturbed(GetParam()));
}

TEST_P(Resume, ReusesAllFramesOfAFinishedRender) {
  ASSERT_EQ(render({"--keep"}).exitCode, 0);
  const RunResult again = render({"--resume", "--keep", "--progress", "plain"});
  EXPECT_EQ(again.exitCode, 0);
  EXPECT_THAT(again.err, HasSubstr("(18 frames, 18 of them already existed, "));
  EXPECT_EQ(made(), undisturbed(GetParam()));
}

TEST_P(Resume, ReusesAllFramesIfStoppedWhileCleaningUp) {
  const auto environment = environmentOf({"remove", "parent", "kill"}, 4, folder_);
  run(folder_, renderArguments(GetParam()), Stdout::kFile, environment);
  EXPECT_TRUE(struck(folder_));
  EXPECT_EQ(made(), undisturbed(GetParam()));
  const RunResult again = render({"--resume", "--progress", "plain"});
  EXPECT_EQ(again.exitCode, 0);
  EXPECT_THAT(again.err, HasSubstr("(18 frames, 18 of them already existed, "));
  EXPECT_EQ(made(), undisturbed(GetParam()));
  EXPECT_THAT(namesIn(folder_.path()), testing::Not(testing::Contains(testing::EndsWith(".poinsot"))));
}

// The body disappears at 1.15 s, which changes frames 12 to 17 only.
TEST_P(Resume, RendersOnlyChangedFramesOfAnEditedScene) {
  const std::string edited = std::string(kTinyScene) + "[[timeline]]\nat = 1.15\nhide = [\"body\"]\n";
  ASSERT_EQ(render({"--keep"}).exitCode, 0);
  folder_.put("tiny.toml", edited);
  const RunResult again = render({"--resume", "--progress", "plain"});
  EXPECT_EQ(again.exitCode, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("(18 frames, 12 of them already existed, "));
  const ScratchFolder other;
  other.put("tiny.toml", edited);
  ASSERT_EQ(run(other, renderArguments(GetParam())).exitCode, 0);
  EXPECT_EQ(made(), filesOf(other.path()));
}

TEST_P(Resume, RendersAllFramesWithOtherSettings) {
  ASSERT_EQ(render({"--keep"}).exitCode, 0);
  const RunResult again = render({"--resume", "--progress", "plain", "--size", "66x36"});
  EXPECT_EQ(again.exitCode, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("(18 frames, "));
  EXPECT_THAT(again.err, testing::Not(HasSubstr("already")));
}

INSTANTIATE_TEST_SUITE_P(Each, Resume, testing::Values(kFilm, kSequence), kindOf);

// ---- segments that were changed

class Segments : public testing::Test {
 protected:
  Segments() {
    folder_.put("tiny.toml", kTinyScene);
    EXPECT_EQ(run(folder_, renderArguments(kFilm, {"--keep"})).exitCode, 0);
  }
  std::filesystem::path segment() const { return folder_ / ".t.mp4.poinsot/segment-000000003-000000005.mp4"; }
  RunResult status(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"status", "t.mp4"};
    words.insert(words.end(), more.begin(), more.end());
    return run(folder_, words);
  }

  ScratchFolder folder_;
};

TEST_F(Segments, AreReportedAsDone) {
  const RunResult told = status();
  EXPECT_EQ(told.exitCode, 0);
  EXPECT_EQ(told.out, "t.mp4: complete; 6 segments: 6 done\n");
}

TEST_F(Segments, AreRenderedAgainIfDamaged) {
  std::string bytes = bytesOf(segment());
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  std::ofstream(segment(), std::ios::binary) << bytes;
  std::filesystem::remove(folder_ / "t.mp4");
  const RunResult told = status();
  EXPECT_EQ(told.exitCode, 1);
  EXPECT_EQ(told.out, "t.mp4: 6 segments: 5 done, 1 corrupt\ncorrupt: frames 3-5\n");
  const RunResult joined = run(folder_, {"assemble", "t.mp4"});
  EXPECT_EQ(joined.exitCode, 4);
  EXPECT_THAT(joined.err, HasSubstr("t.mp4: frames 3-5 are damaged"));
  const RunResult again = run(folder_, renderArguments(kFilm, {"--resume", "--progress", "plain"}));
  EXPECT_THAT(again.err, HasSubstr("15 of them already existed"));
  EXPECT_EQ(filesOf(folder_.path()), undisturbed(kFilm));
}

TEST_F(Segments, AreNotJoinedIfOneIsMissing) {
  std::filesystem::remove(folder_ / ".t.mp4.poinsot/segment-000000003-000000005.json");
  std::filesystem::remove(folder_ / "t.mp4");
  EXPECT_EQ(status().out, "t.mp4: 6 segments: 5 done, 1 missing\nmissing: frames 3-5\n");
  const RunResult joined = run(folder_, {"assemble", "t.mp4", "--quiet"});
  EXPECT_EQ(joined.exitCode, 4);
  EXPECT_EQ(joined.err,
            "poinsot: error: t.mp4: frames 3-5 are missing; make them: poinsot render SCENE -o t.mp4 --resume\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "t.mp4"));
}

// A kill while the work folder is removed may leave any part of it.
TEST_F(Segments, AreNotNeededOnceTheFilmIsComplete) {
  const std::filesystem::path work = folder_ / ".t.mp4.poinsot";
  const std::string before = bytesOf(folder_ / "t.mp4");
  const auto expectWhole = [&](const std::string& segments) {
    EXPECT_EQ(status().out, "t.mp4: complete\n");
    EXPECT_EQ(status().exitCode, 0);
    EXPECT_THAT(status({"--json"}).out, AllOf(HasSubstr("\"complete\": true"), HasSubstr("\"missing\": []")));
    EXPECT_EQ(status({"--shards"}).exitCode, 0);
    for (const char* other : {"t.mp4", "other.mp4"}) {
      const RunResult joined = run(folder_, {"assemble", "t.mp4", "-o", other});
      EXPECT_EQ(joined.exitCode, 4);
      EXPECT_THAT(joined.err, AllOf(HasSubstr(segments), EndsWith("; the film itself is complete\n")));
    }
    EXPECT_EQ(bytesOf(folder_ / "t.mp4"), before);
  };
  std::filesystem::remove(segment());
  expectWhole("frames 3-5 are damaged");
  std::filesystem::remove(work / "segment-000000003-000000005.json");
  expectWhole("frames 3-5 are missing");
  for (const std::string& name : namesIn(work))
    if (name != "job.json") std::filesystem::remove(work / name);
  expectWhole("t.mp4: ");
  const RunResult again = run(folder_, renderArguments(kFilm, {"--resume", "--progress", "plain"}));
  EXPECT_THAT(again.err, HasSubstr("18 of them already existed"));
  EXPECT_FALSE(std::filesystem::exists(work));
}

// Files that no render writes: rubbish instead of a record or of the job.
TEST_F(Segments, AreMissingIfTheirRecordIsInvalid) {
  std::ofstream(folder_ / ".t.mp4.poinsot/segment-000000003-000000005.json") << "{\"frames\": [3, ";
  std::filesystem::remove(folder_ / "t.mp4");
  EXPECT_EQ(status().out, "t.mp4: 6 segments: 5 done, 1 missing\nmissing: frames 3-5\n");
  std::ofstream(folder_ / ".t.mp4.poinsot/job.json") << "[]";
  for (const std::string command : {"assemble", "status"}) {
    const RunResult refused = run(folder_, {command, "t.mp4"});
    EXPECT_EQ(refused.exitCode, 4);
    EXPECT_THAT(refused.err,
                HasSubstr("; ./.t.mp4.poinsot/job.json is missing or damaged; poinsot render SCENE -o "
                          "t.mp4 --resume writes it again and keeps whole segments\n"));
  }
  const RunResult again = run(folder_, renderArguments(kFilm, {"--resume", "--progress", "plain"}));
  EXPECT_THAT(again.err, HasSubstr("15 of them already existed"));
  EXPECT_EQ(filesOf(folder_.path()), undisturbed(kFilm));
}

TEST_F(Segments, AreStaleIfFromAnotherScene) {
  ASSERT_EQ(run(folder_, renderArguments(kFilm, {"--shard", "1/2"})).exitCode,
            0);  // --shard is reproducible, so pixels may differ
  const RunResult told = status({"--json"});
  EXPECT_EQ(told.exitCode, 1);
  EXPECT_THAT(told.out, HasSubstr("\"shards_to_run\": \"2\""));
  EXPECT_THAT(status().out, HasSubstr("3 done, 3 stale\nstale: frames 3-5, 9-11, 15-17\nshards to run: 2 of 2\n"));
  EXPECT_THAT(run(folder_, {"assemble", "t.mp4"}).err,
              HasSubstr("frames 3-5, 9-11, 15-17 are from another scene or other settings; make them: poinsot "
                        "render SCENE -o t.mp4 --shard 2/2\n"));
}

TEST_F(Segments, CanBeJoinedUnderAnotherName) {
  EXPECT_EQ(run(folder_, {"assemble", "t.mp4", "-o", "other.mp4", "--keep"}).exitCode, 0);
  EXPECT_EQ(bytesOf(folder_ / "other.mp4"), bytesOf(folder_ / "t.mp4"));
  EXPECT_EQ(run(folder_, {"assemble", "t.mp4"}).exitCode, 0);
  EXPECT_EQ(status().out, "t.mp4: complete\n");
}

// Another program computes the digests of the files. A second run gives an equal manifest, except for the times.
TEST(Manifest, DescribesAFilmAndItsFrames) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  const auto manifest = [&](const std::string& name) {
    EXPECT_EQ(run(folder, renderArguments(kFilm, {"--manifest", name})).exitCode, 0);
    auto json = nlohmann::json::parse(bytesOf(folder / name));
    EXPECT_EQ(json.at("spent").at("frames_made"), 18);
    json.erase("spent");
    return json;
  };
  const auto told = manifest("m.json");
  EXPECT_EQ(told.at("frame_digests").size(), 18u);
  EXPECT_EQ(told.at("frames"), (nlohmann::json{0, 17}));
  EXPECT_EQ(told.at("settings").at("size"), (nlohmann::json{64, 36}));
  const std::string sum = told.at("files").at(0).at("sha256");
  const std::string check =
      "cd " + folder.path().string() + " && echo '" + sum + "  t.mp4' | sha256sum -c --status";
  EXPECT_EQ(std::system(check.c_str()), 0);
  EXPECT_EQ(manifest("n.json"), told);
}

TEST(Status, ReportsAnErrorIfNothingExists) {
  const ScratchFolder folder;
  const RunResult told = run(folder, {"status", "t.mp4"});
  EXPECT_EQ(told.exitCode, 4);
  EXPECT_EQ(told.err,
            "poinsot: error: t.mp4: no render in progress here; nothing with that name exists; make it: poinsot "
            "render SCENE -o t.mp4\n");
  EXPECT_EQ(run(folder, {"status", "t_{frame}.png"}).exitCode, 4);
}

TEST(Status, ReportsAForeignFile) {
  const ScratchFolder folder;
  folder.put("t.mp4", "not a film");
  for (const std::string command : {"assemble", "status"}) {
    const RunResult told = run(folder, {command, "t.mp4"});
    EXPECT_EQ(told.exitCode, 4);
    EXPECT_THAT(told.err, HasSubstr("; the file there was written by another program, or is too damaged to be "
                                    "recognised; poinsot render SCENE -o t.mp4 --force replaces it\n"));
  }
}

TEST(Status, ReportsFinishedAndMissingFramesOfASequence) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  ASSERT_EQ(run(folder, renderArguments(kShortSequence)).exitCode, 0);
  const auto status = [&](const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"status", kShortSequence.name};
    words.insert(words.end(), more.begin(), more.end());
    return run(folder, words);
  };
  const std::string next =
      "to make more frames of the scene: poinsot render SCENE -o 't_{frame:03}.png' --resume\n";
  EXPECT_EQ(status().exitCode, 0);
  EXPECT_EQ(status().out, "t_{frame:03}.png: frames 0-5 exist\n" + next);
  EXPECT_EQ(status({"--shards"}).out, "\n");
  const auto json = nlohmann::json::parse(status({"--json"}).out);
  EXPECT_EQ(json.at("complete"), nullptr);
  EXPECT_EQ(json.at("frames"), nlohmann::json({0, 5}));
  EXPECT_THAT(run(folder, renderArguments(kShortSequence, {"--resume", "--progress", "plain"})).err,
              HasSubstr("6 of them already existed"));

  std::filesystem::remove(folder / "t_003.png");
  folder.put("t_004.png", "another picture");
  folder.put("t_0009.png", bytesOf(folder / "t_000.png"));  // the name does not match the pattern
  EXPECT_EQ(status().exitCode, 1);
  EXPECT_EQ(status().out,
            "t_{frame:03}.png: frames 0-2, 5-5 exist\n"
            "missing: frames 3-4\n" +
                next);
  EXPECT_EQ(nlohmann::json::parse(status({"--json"}).out).at("missing"), nlohmann::json({{3, 4}}));
  EXPECT_EQ(status({"--shards"}).exitCode, 1);
}

}  // namespace
}  // namespace poinsot::faults
