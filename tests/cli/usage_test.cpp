// SPDX-License-Identifier: Apache-2.0
// Tests the command line itself: help, versions, usage errors, streams. Nothing is rendered.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "support/program_run.h"
#include "support/shell_run.h"

namespace poinsot {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

const std::vector<std::string> kCommands{"doctor",  "preview", "new",    "render",     "still", "sweep",
                                         "gallery", "submit",  "info",   "trajectory", "grade", "check",
                                         "explain", "schema",  "status", "assemble",   "diff",  "golden"};

TEST(Usage, HelpListsAllPublicCommands) {
  const ScratchFolder folder;
  const auto help = run(folder, {"--help"});
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_THAT(help.err, IsEmpty());
  for (const auto& command : kCommands) EXPECT_THAT(help.out, HasSubstr("\n  " + command + " "));
  EXPECT_THAT(help.out, Not(HasSubstr("worker")));
  EXPECT_THAT(help.out, HasSubstr("poinsot render scenes/tennis_racket.toml -o out/tennis_racket.mp4"));
  EXPECT_EQ(run(folder, {"help"}).out, help.out);
  EXPECT_EQ(run(folder, {}).out, help.out);
}

TEST(Usage, EveryCommandHasHelpWithAnExample) {
  const ScratchFolder folder;
  for (const auto& command : kCommands) {
    const auto help = run(folder, {command, "--help"});
    EXPECT_EQ(help.exitCode, 0) << command;
    EXPECT_THAT(help.out, HasSubstr("\n  poinsot " + command)) << command;
    EXPECT_EQ(run(folder, {"help", command}).out, help.out);
  }
}

TEST(Usage, VersionNamesProgramLibrariesAndLicence) {
  const ScratchFolder folder;
  const auto version = run(folder, {"--version"});
  EXPECT_EQ(version.exitCode, 0);
  EXPECT_THAT(version.out, StartsWith("poinsot 0."));
  for (const char* library : {"libpng 1.6", "libavcodec", "libavformat", "OpenGL"})
    EXPECT_THAT(version.out, HasSubstr(library));
  EXPECT_EQ(version.out.back(), '\n');
}

TEST(Usage, ExplainsKeysOnLinesThatFitATerminal) {
  const ScratchFolder folder;
  const auto fov = run(folder, {"explain", "camera.fov", "racket"});
  EXPECT_EQ(fov.exitCode, 0) << fov.err;
  EXPECT_THAT(fov.out, HasSubstr("\n  default  "));
  EXPECT_THAT(fov.out, HasSubstr("[camera]\n           fov = "));
  EXPECT_THAT(fov.out, HasSubstr("\nshape = \"racket\"\n"));
  std::istringstream lines(run(folder, {"explain"}).out + run(folder, {"explain", "body"}).out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
  EXPECT_THAT(run(folder, {"explain", "golden.test.image"}).out, HasSubstr("[[test]]\n           image = "));
  EXPECT_THAT(run(folder, {"explain", "size"}).out, AllOf(HasSubstr("body.size\n"), HasSubstr("\ngolden.size\n")));
  EXPECT_THAT(run(folder, {"explain", "flip_mxa"}).err, HasSubstr("did you mean flip_max?"));
  const auto some = run(folder, {"explain", "flip_mxa", "camera.fov", "fovv"});
  EXPECT_EQ(some.exitCode, 2);
  EXPECT_THAT(some.out, HasSubstr("camera.fov\n"));  // a wrong name does not hide the others
  EXPECT_THAT(some.err, AllOf(HasSubstr("flip_max"), HasSubstr("fov?")));
  const auto bad = run(folder, {"explain", "fovv"});
  EXPECT_EQ(bad.exitCode, 2);
  EXPECT_THAT(bad.err, HasSubstr("did you mean fov?"));
}

TEST(Usage, RejectsPreviewWithUntrusted) {
  const ScratchFolder folder;
  const auto result = run(folder, {"preview", "a.toml", "--untrusted"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.err, HasSubstr("not possible with preview, which needs the network"));
}

TEST(Usage, SchemaIsJson) {
  const ScratchFolder folder;
  const auto schema = run(folder, {"schema"});
  EXPECT_EQ(schema.exitCode, 0);
  const auto json = nlohmann::json::parse(schema.out);
  EXPECT_EQ(json.at("$schema"), "http://json-schema.org/draft-04/schema#");
  EXPECT_TRUE(json.at("properties").contains("body"));
}

struct BadUsage {
  std::vector<std::string> words;
  std::string says;
};

TEST(Usage, RejectsInvalidArgumentsWithAnExplanation) {
  const ScratchFolder folder;
  folder.put("a.toml", kGoodScene);
  const BadUsage cases[] = {
      {{"rendr", "a.toml"}, "unknown command 'rendr'; did you mean 'render'?"},
      {{"xyzzy"}, "unknown command 'xyzzy' (poinsot --help lists the commands)"},
      {{"help", "stil"}, "did you mean 'still'?"},
      {{"render"}, "SCENE is required"},
      {{"render", "a.toml", "--forse"}, "unexpected '--forse'; did you mean '--force'?"},
      {{"render", "a.toml", "b.toml"}, "unexpected 'b.toml'"},
      {{"render", "a.toml", "-o", "a.avi"}, "output 'a.avi': unsupported file type; possible names: NAME.mp4"},
      {{"render", "a.toml", "-o", "a_{n}.png"}, "not a frame number: {n}"},
      {{"render", "a.toml", "-o", "a.png"},
       "a.png takes one frame, and 120 are selected: choose one with --frames 0"},
      {{"render", "a.toml", "--frames", "9-3"}, "--frames '9-3': the first frame, 9, comes after the last, 3"},
      {{"render", "a.toml", "--frames", "100-120"}, "--frames 100-120: the film has frames 0 to 119"},
      {{"render", "a.toml", "--size", "160"}, "--size '160': must be WIDTHxHEIGHT"},
      {{"render", "a.toml", "--size", "161x91"},
       "a film of 161x91 pixels: width and height must be even (chroma has half of each); the nearest is 160x90"},
      {{"render", "a.toml", "--size", "8x8"}, "sides must be from 16 to 8192 pixels"},
      {{"render", "a.toml", "--size", "8193x90"}, "sides must be from 16 to 8192 pixels"},
      {{"render", "a.toml", "-j", "0"}, "not in range"},
      {{"render", "a.toml", "--backend", "metal"}, "metal not in {auto,osmesa,egl}"},
      {{"render", "a.toml", "--fps", "zero"}, "--fps zero: error: time.fps: "},
      {{"render", "a.toml", "--fps", "0"}, "--fps 0: error: time.fps: "},
      {{"render", "a.toml", "-D", "time.fps=0"}, "-D time.fps=0: error: time.fps: "},
      {{"render", "a.toml", "-q", "1080"}, "-q 1080: error: output.quality: expected one of \"preview\""},
      {{"render", "a.toml", "-o", ""}, "--output: is empty"},
      {{"still", "a.toml", "-o", ""}, "--output: is empty"},
      {{"render", "a.toml", "--fps", ""}, "--fps: is empty"},
      {{"render", "a.toml", "--size", ""}, "--size: is empty"},
      {{"render", "a.toml", "-D", "time.duratoin=4"}, "time.duration"},
      {{"render", "a.toml", "-D", "time.duration=-4"}, "time.duration"},
      {{"still", "a.toml", "--time", "4.5", "-o", "a.png"}, "--time 4.5: the film lasts from 0 to 4 s"},
      {{"still", "a.toml", "--time", "1 min", "-o", "a.png"}, "--time 1 min: the film lasts from 0 to 4 s"},
      {{"still", "a.toml", "--time", "2 m", "-o", "a.png"}, "--time '2 m': expected a time in one of s, "},
      {{"still", "a.toml", "--time", "soon", "-o", "a.png"}, "--time 'soon': expected a time"},
      {{"still", "a.toml", "--time", "", "-o", "a.png"}, "--time '': expected a time"},
      {{"still", "a.toml", "--time", "nan", "-o", "a.png"}, "--time nan"},
      {{"still", "a.toml", "-o", "a.mp4"}, "a still is one NAME.png"},
      {{"render", "a.toml", "--bits", "16", "-o", "a.mov"},
       "--bits 16: the pictures of a film have 8; NAME_{frame:05}.png and NAME.png can have 16"},
      {{"render", "a.toml", "--bits", "16"}, "--bits 16: the pictures of a film have 8"},
      {{"render", "none.toml", "--bits", "16"}, "--bits 16: the pictures of a film have 8"},
      {{"submit", "a.toml", "--bits", "16", "-o", "a.mp4"}, "--bits 16: the pictures of a film have 8"},
      {{"still", "a.toml", "--bits", "16", "-o", "a.pdf"},
       "--bits 16: the pictures in a figure have 8; NAME.png can have 16"},
      {{"still", "a.toml", "--bits", "10", "-o", "a.png"}, "--bits: "},
      {{"check"}, "SCENE is required"},
  };
  for (const BadUsage& bad : cases) {
    const auto result = run(folder, bad.words);
    EXPECT_EQ(result.exitCode, 2) << bad.says << "\n" << result.err;
    EXPECT_THAT(result.err, HasSubstr(bad.says));
    EXPECT_THAT(result.out, IsEmpty()) << bad.says;
  }
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{"a.toml"});
}

TEST(Usage, RefusesAStackThatIsTooSmall) {
  const ScratchFolder folder;
  const auto result = runShell(folder.path(), "ulimit -s 64; " POINSOT_PROGRAM " --version");
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_EQ(result.out,
            "poinsot: error: the stack limit is 64 KiB, but poinsot needs 1024 KiB; run: ulimit -s 1024\n");
}

TEST(Usage, AcceptsTimesWithAUnit) {
  const ScratchFolder folder;
  folder.put("a.toml", kGoodScene);  // 4 s of film
  for (const char* time : {"4", "4 s", "4000ms", "0.05 min"}) {
    const auto result = run(folder, {"still", "a.toml", "--time", time, "--dry-run"});
    EXPECT_EQ(result.exitCode, 0) << time << "\n" << result.err;
  }
  EXPECT_EQ(run(folder, {"still", "a.toml", "--time", "4001 ms", "--dry-run"}).exitCode, 2);
}

TEST(Usage, MessagesCarryNoControlCharacters) {
  const ScratchFolder folder;
  const std::string evil = "\x1b]0;x\x07\r\xe2\x80\xae";
  for (const std::vector<std::string>& words : {std::vector<std::string>{evil},
                                                {"render", evil},
                                                {"render", "a", "-o", evil},
                                                {"render", "a", evil},
                                                {"render", "a", "--frames", evil},
                                                {"check", evil},
                                                {"render", "a", "-D", evil}}) {
    const auto result = run(folder, words);
    EXPECT_EQ(result.exitCode, 2) << result.err;
    EXPECT_THAT(result.err, AllOf(Not(HasSubstr("\x1b")), Not(HasSubstr("\x07")), Not(HasSubstr("\r")),
                                  Not(HasSubstr("\xe2\x80\xae"))));
  }
}

TEST(Program, ExitsWith141IfTheReaderIsGone) {
  const ScratchFolder folder;
  for (const auto& words : {std::vector<std::string>{"--help"}, {"--version"}, {"schema"}}) {
    const auto result = run(folder, words, Stdout::kBrokenPipe);
    EXPECT_EQ(result.exitCode, 141) << words[0];
    EXPECT_THAT(result.err, IsEmpty());
  }
}

TEST(Program, ExitsWith4IfOutputIsLost) {
  const ScratchFolder folder;
  EXPECT_EQ(run(folder, {"schema"}, Stdout::kClosed).exitCode, 4);
  const auto full = run(folder, {"schema"}, Stdout::kFull);
  EXPECT_EQ(full.exitCode, 4);
  EXPECT_THAT(full.err, HasSubstr("poinsot: error: standard output: No space left on device"));
}

}  // namespace
}  // namespace poinsot
