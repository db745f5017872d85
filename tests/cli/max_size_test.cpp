// SPDX-License-Identifier: Apache-2.0
// Tests films with --max-size: the size of the file, the options that repeat the film, and refusals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <iterator>
#include <regex>
#include <sstream>
#include <thread>

#include "support/program_run.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

using Words = std::vector<std::string>;

/// Film of 1 s at 30 frames/s and 480x270, with a caption.
const char* const kScene =
    "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 10, 0]\n[time]\nduration = 1\n"
    "[output]\nsize = [480, 270]\n[[timeline]]\nat = 0\ncaption = 'A flip'\n";

class MaxSize : public testing::Test {
 protected:
  void SetUp() override { folder_.put("a.toml", kScene); }

  RunResult render(const Words& more, int exitCode = 0) {
    Words words{"render", "a.toml"};
    words.insert(words.end(), more.begin(), more.end());
    RunResult result = run(folder_, words);
    EXPECT_EQ(result.exitCode, exitCode) << result.err;
    return result;
  }

  /// Renders a film without --max-size and returns its size.
  std::uintmax_t sizeAsAsked(const std::string& name) {
    render({"-o", name, "--reproducible", "--quiet"});
    return sizeOf(name);
  }

  std::uintmax_t sizeOf(const std::string& name) const { return fs::file_size(folder_ / name); }

  std::string bytes(const std::string& name) const { return bytesOf(folder_ / name); }

  ScratchFolder folder_;
};

/// Returns the options after "replace --max-size by".
Words printedOptions(const std::string& err) {
  std::smatch found;
  if (!std::regex_search(err, found, std::regex("replace --max-size by (.*)\n"))) return {};
  std::istringstream stream(found[1].str());
  return {std::istream_iterator<std::string>(stream), {}};
}

std::string limitOf(std::uintmax_t size) { return std::to_string(size); }

TEST_F(MaxSize, MakesASmallerGifAndPrintsOptionsThatRepeatIt) {
  const auto asked = sizeAsAsked("asked.gif");
  const auto most = asked / 3;
  const RunResult result = render({"-o", "o.gif", "--max-size", limitOf(most), "-j", "1"});
  EXPECT_LE(sizeOf("o.gif"), most);
  EXPECT_GT(sizeOf("o.gif"), most / 2);
  EXPECT_THAT(result.err, HasSubstr("tried 480x270, 30 frames/s, 255 colours: "));
  EXPECT_THAT(result.err, HasSubstr("(" + std::to_string(sizeOf("o.gif")) + " bytes); to make this film again, "));
  EXPECT_THAT(namesIn(folder_.path()),
              ElementsAre("a.toml", "asked.gif", "asked.srt", "asked.vtt", "o.gif", "o.srt", "o.vtt"));

  Words repeated{"-o", "again.gif", "--quiet"};
  for (const std::string& word : printedOptions(result.err)) repeated.push_back(word);
  ASSERT_GT(repeated.size(), 3u) << result.err;
  render(repeated);
  EXPECT_TRUE(bytes("again.gif") == bytes("o.gif"));

  render({"-o", "two.gif", "--max-size", limitOf(most), "-j", "2", "--quiet"});
  EXPECT_TRUE(bytes("two.gif") == bytes("o.gif"));
}

TEST_F(MaxSize, WritesTheFilmAsAskedIfItFits) {
  const auto asked = sizeAsAsked("asked.gif");
  const RunResult result = render({"-o", "o.gif", "--max-size", limitOf(asked)});
  EXPECT_TRUE(bytes("o.gif") == bytes("asked.gif"));
  EXPECT_THAT(result.err, HasSubstr("replace --max-size by --reproducible\n"));
  EXPECT_THAT(result.err, Not(HasSubstr("tried")));
  const RunResult quiet = render({"-o", "p.gif", "--max-size", "5MB", "--reproducible", "--quiet"});
  EXPECT_EQ(quiet.err, "");
  EXPECT_TRUE(bytes("p.gif") == bytes("asked.gif"));
}

TEST_F(MaxSize, MakesASmallerMp4WithItsManifest) {
  const auto most = sizeAsAsked("asked.mp4") / 2;
  const RunResult result = render({"-o", "o.mp4", "--max-size", limitOf(most), "--manifest", "m.json"});
  EXPECT_LE(sizeOf("o.mp4"), most);
  EXPECT_THAT(result.err, HasSubstr("-D output.crf="));
  Words repeated{"-o", "again.mp4", "--quiet"};
  for (const std::string& word : printedOptions(result.err)) repeated.push_back(word);
  render(repeated);
  EXPECT_TRUE(bytes("again.mp4") == bytes("o.mp4"));
  EXPECT_THAT(bytes("m.json"), HasSubstr("o.mp4"));
}

TEST_F(MaxSize, KeepsWhatTheUserFixes) {
  const auto most = sizeAsAsked("asked.gif") * 4 / 5;
  const RunResult result =
      render({"-o", "o.gif", "--max-size", limitOf(most), "--size", "480x270", "--fps", "30"});
  EXPECT_THAT(result.err, HasSubstr("replace --max-size by -D output.colors="));
  const RunResult fixed = render({"-o", "p.gif", "--max-size", limitOf(most), "--size", "480x270", "--frames",
                                  "0-29", "-D", "output.colors=255"},
                                 2);
  EXPECT_THAT(fixed.err, HasSubstr("do not fix its size, frame rate, colours, or allow --max-size "));
  EXPECT_FALSE(fs::exists(folder_ / "p.gif"));
  const RunResult quality = render({"-o", "q.mp4", "--max-size", "1kB", "-q", "preview", "--fps", "30"}, 2);
  EXPECT_THAT(quality.err, HasSubstr("do not fix its size, frame rate, quality, or allow --max-size "));
}

TEST_F(MaxSize, LeavesAnEarlierFilmIfNoFilmFits) {
  sizeAsAsked("o.gif");
  const std::string before = bytes("o.gif");
  const RunResult result = render({"-o", "o.gif", "--max-size", "2kB"}, 2);
  EXPECT_THAT(result.err, HasSubstr("--max-size 2kB: not possible; the smallest film has "));
  EXPECT_THAT(result.err, HasSubstr("320x180, 10 frames/s, 32 colours); make the film shorter"));
  EXPECT_TRUE(bytes("o.gif") == before);
  render({"-o", "new.gif", "--max-size", "2kB", "--trace", "t.json", "--manifest", "m.json"}, 2);
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.toml", "o.gif", "o.srt", "o.vtt"));
}

TEST_F(MaxSize, LeavesNothingAfterASignal) {
  ProgramRun program(folder_, {"render", "a.toml", "-D", "time.duration=60", "-o", "o.gif", "--max-size", "5MB"});
  const auto segmentIsThere = [&] {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder_ / ".o.gif.poinsot", ignored))
      if (entry.path().extension() == ".mkv") return true;
    return false;
  };
  for (int i = 0; i < 600 && !segmentIsThere(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  ASSERT_TRUE(segmentIsThere());
  program.signal(SIGINT);
  const RunResult result = program.wait();
  EXPECT_EQ(result.exitCode, 128 + SIGINT) << result.err;
  EXPECT_THAT(result.err, Not(HasSubstr("--resume")));
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.toml"));
}

TEST_F(MaxSize, MakesNothingInADryRun) {
  const RunResult result = render({"-o", "o.gif", "--max-size", "100kB", "--dry-run"});
  EXPECT_THAT(result.out, HasSubstr("30 frames (0-29), 480x270"));
  EXPECT_THAT(result.err, HasSubstr("--max-size 100kB: the film may get a smaller picture"));
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.toml"));
}

TEST_F(MaxSize, LimitsTheFilmOfASweep) {
  const auto sweep = [&](const std::string& name, const Words& more) {
    Words words{"sweep", "a.toml", "-D", "time.start=0|1", "--quiet", "-o", name};
    words.insert(words.end(), more.begin(), more.end());
    const RunResult result = run(folder_, words);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return sizeOf(name);
  };
  const auto most = sweep("asked.gif", {}) / 2;
  EXPECT_LE(sweep("o.gif", {"--max-size", limitOf(most)}), most);
}

TEST_F(MaxSize, RejectsWhatCannotBeLimited) {
  const auto refused = [&](const Words& words) {
    const RunResult result = run(folder_, words);
    EXPECT_EQ(result.exitCode, 2) << result.err;
    return result.err;
  };
  const Words film{"render", "a.toml", "--max-size", "1MB", "-o"};
  const auto with = [&](const Words& more) {
    Words words = film;
    words.insert(words.end(), more.begin(), more.end());
    return refused(words);
  };
  EXPECT_THAT(with({"f_{frame}.png"}), HasSubstr("--max-size 1MB: possible only for a film: NAME.mp4"));
  EXPECT_THAT(with({"f.png", "--frames", "0"}), HasSubstr("--max-size 1MB: possible only for a film"));
  EXPECT_THAT(with({"-", "--format", "mp4"}), HasSubstr("not possible with -o -"));
  for (const Words& parts : {Words{"--resume"}, {"--keep"}, {"--shard", "1/2"}, {"--shards-left", "2"}}) {
    Words words{"o.mp4"};
    words.insert(words.end(), parts.begin(), parts.end());
    EXPECT_THAT(with(words), HasSubstr("not possible with --resume, --keep, --shard and --shards-left"));
  }
  EXPECT_THAT(refused({"render", "a.toml", "-o", "o.gif", "--max-size", "5M"}),
              HasSubstr("--max-size '5M': must be"));
  EXPECT_THAT(refused({"sweep", "a.toml", "-D", "time.start=0|1", "--max-size", "1MB"}),
              HasSubstr("are for films"));
  EXPECT_THAT(
      refused({"sweep", "a.toml", "-D", "time.start=0|1", "--series", "-o", "{value}.mp4", "--max-size", "1MB"}),
      HasSubstr("--max-size: limits one film, not a series"));
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.toml"));
}

}  // namespace
}  // namespace poinsot
