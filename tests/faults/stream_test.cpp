// SPDX-License-Identifier: Apache-2.0
// A film or sequence on standard output has the same pictures as one in files, and ends as cleanly.
#include <gmock/gmock.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "faults/tiny_film.h"
#include "support/shell_run.h"

namespace poinsot::faults {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Stream : public testing::Test {
 protected:
  Stream() {
    folder_.put("tiny.toml", kTinyScene);
    std::filesystem::create_directory(folder_ / "tmp");
  }
  std::vector<std::string> environment() const { return {"TMPDIR=" + (folder_ / "tmp").string()}; }
  static std::vector<std::string> arguments(const std::string& format, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--format", format});
    return renderArguments({"-"}, more);
  }
  RunResult stream(const std::string& format, const std::vector<std::string>& more = {},
                   Stdout to = Stdout::kFile) const {
    return run(folder_, arguments(format, more), to, environment());
  }
  /// Expects that no parts of the output are left under TMPDIR.
  void expectNothingLeft() const { EXPECT_THAT(namesIn(folder_ / "tmp"), IsEmpty()); }

  ScratchFolder folder_;
};

// Returns ffmpeg's checksum of each decoded frame with its time.
std::string decodedSums(const std::filesystem::path& film) {
  const std::string command = "ffmpeg -v error -i '" + film.string() + "' -f framemd5 - | grep -v '^#'";
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string sums;
  for (char line[256]; std::fgets(line, sizeof line, pipe) != nullptr;) sums += line;
  EXPECT_EQ(pclose(pipe), 0);
  return sums;
}

// Oracle: the files of an ordinary run, one after the other.
TEST_F(Stream, ContainsThePngFilesOfASequenceInOrder) {
  std::string all;
  for (const auto& [name, bytes] : undisturbed(kSequence)) all += bytes;
  for (const char* jobs : {"1", "2", "4"}) {
    const RunResult told = stream("png", {"-j", jobs});
    EXPECT_EQ(told.exitCode, 0) << told.err;
    EXPECT_EQ(told.out, all) << jobs;
  }
  expectNothingLeft();
}

// Oracle: the film of an ordinary run, as ffmpeg decodes both.
TEST_F(Stream, ContainsThePicturesAndTimesOfAFilm) {
  const RunResult told = stream("mp4");
  ASSERT_EQ(told.exitCode, 0) << told.err;
  folder_.put("streamed.mp4", told.out);
  folder_.put("film.mp4", undisturbed(kFilm).front().second);
  const std::string sums = decodedSums(folder_ / "film.mp4");
  EXPECT_THAT(sums, HasSubstr("\n0,         17,         17,"));
  EXPECT_EQ(decodedSums(folder_ / "streamed.mp4"), sums);
  EXPECT_LT(told.out.find("moof"), told.out.find("mdat"));  // fragments with their own index
  for (const char* jobs : {"2", "4"}) EXPECT_EQ(stream("mp4", {"-j", jobs}).out, told.out) << jobs;
  expectNothingLeft();
}

TEST_F(Stream, EndsQuietlyWithoutAReader) {
  for (const char* format : {"png", "mp4"}) {
    const RunResult told = stream(format, {"--progress", "none"}, Stdout::kBrokenPipe);
    EXPECT_EQ(told.exitCode, 141) << format;
    EXPECT_EQ(told.err, "") << format;
  }
  expectNothingLeft();
}

TEST_F(Stream, ReportsAFullDisk) {
  for (const char* format : {"png", "mp4"}) {
    const RunResult told = stream(format, {"--progress", "none"}, Stdout::kFull);
    EXPECT_EQ(told.exitCode, 4) << format;
    EXPECT_THAT(told.err, HasSubstr("standard output: ")) << format;
    EXPECT_THAT(told.err, HasSubstr("No space left on device")) << format;
  }
  expectNothingLeft();
}

// The pipe is full after 64 KiB, and the program waits for room.
TEST_F(Stream, EndsOnASignalIfTheReaderDoesNotRead) {
  std::vector<std::string> words = renderArguments({"-", 30, "320x180", 10}, {"--format", "png"});
  ProgramRun running(folder_, words, Stdout::kUnread, environment());
  sleep(2);
  const auto sent = std::chrono::steady_clock::now();
  running.signal(SIGTERM);
  EXPECT_EQ(running.wait().exitCode, 143);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - sent).count(), 2.0);
  expectNothingLeft();
}

TEST_F(Stream, RejectsOptionsForFiles) {
  const auto refusal = [&](const std::vector<std::string>& words) {
    const RunResult told = run(folder_, words);
    EXPECT_EQ(told.exitCode, 2);
    return told.err;
  };
  EXPECT_THAT(refusal({"render", "tiny.toml", "-o", "-"}), HasSubstr("choose --format png or --format mp4"));
  EXPECT_THAT(refusal({"render", "tiny.toml", "-o", "-", "--format", "gif"}), HasSubstr("got 'gif'"));
  EXPECT_THAT(refusal({"render", "tiny.toml", "-o", "a.mp4", "--format", "mp4"}),
              HasSubstr("possible only with -o -"));
  for (const char* option : {"--resume", "--keep", "--shard=1/2", "--manifest=m.json"})
    EXPECT_THAT(refusal({"render", "tiny.toml", "-o", "-", "--format", "png", option}), HasSubstr("need a file"));
  EXPECT_THAT(refusal({"submit", "tiny.toml", "-o", "-", "--format", "png"}), HasSubstr("write files"));
}

TEST_F(Stream, RejectsATerminal) {
  const ShellResult told =
      runShell(folder_.path(), "script -qec '" POINSOT_PROGRAM " render tiny.toml -o - --format png' /dev/null");
  EXPECT_EQ(told.exitCode, 2);
  EXPECT_THAT(told.out, HasSubstr("-o -: standard output is a terminal; send it to a program or a file"));
}

}  // namespace
}  // namespace poinsot::faults
