// SPDX-License-Identifier: Apache-2.0
// Tests refusals of the command line and of files: each gives its message and makes nothing. The expected messages
// are written by hand and contain the facts that a user needs for the repair.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/program_run.h"

namespace poinsot {
namespace {

using ::testing::HasSubstr;

struct Refusal {
  std::vector<std::string> words;
  const char* says;
  int exitCode = 2;
};

class ErrorMessages : public testing::Test {
 protected:
  void put(const std::string& name, const std::string& text) const { folder_.put(name, text); }

  void expectAll(const std::vector<Refusal>& all, const std::vector<std::string>& environment = {}) const {
    const auto before = namesIn(folder_.path());
    for (const Refusal& one : all) {
      std::string line;
      for (const std::string& word : one.words) line += word + " ";
      const RunResult result = run(folder_, one.words, Stdout::kFile, environment);
      EXPECT_EQ(result.exitCode, one.exitCode) << line;
      EXPECT_THAT(result.err, HasSubstr(one.says)) << line;
      EXPECT_EQ(namesIn(folder_.path()), before) << line;
    }
  }

  ScratchFolder folder_;
};

TEST_F(ErrorMessages, ExplainInvalidOutputNames) {
  put("s.toml", kGoodScene);
  std::filesystem::create_directory(folder_ / "full.png");
  expectAll({
      {{"render", "s.toml", "-o", "out/"}, "output 'out/': not a file name; possible names: NAME.mp4"},
      {{"render", "s.toml", "-o", "a_{frame}.mp4"}, "a film is one file, so its name must not contain {frame}"},
      {{"render", "s.toml", "-o", "a_{frame}_{frame}.png"}, "more than one pair of braces"},
      {{"render", "s.toml", "-o", "a_{x}.png"}, "not a frame number: {x}"},
      {{"render", "s.toml", "-o", "a_{frame}/b.png"}, "the frame number is in the folder's name"},
      {{"render", "s.toml", "-o", "a.png"},
       "a.png takes one frame, and 120 are selected: choose one with --frames 0"},
      {{"still", "s.toml", "-o", "full.png", "--force"},
       "full.png: is a folder; outputs are written to regular files",
       4},
      {{"submit", "s.toml", "-o", "-", "--format", "mp4"},
       "-o -: not possible, because tasks on several machines write files"},
      {{"render", "s.toml", "-o", "a.mp4", "--trace", "a.mp4"}, "--trace a.mp4 is the same file as -o a.mp4"},
  });
}

TEST_F(ErrorMessages, ExplainConflictingOptions) {
  put("s.toml", kGoodScene);
  put("golden.toml", "[[test]]\nscene = 's.toml'\n");
  expectAll({
      {{"render", "s.toml", "--shard", "3/2", "-o", "a.mp4"}, "--shard '3/2': a shard is k/n, such as 2/7"},
      {{"render", "s.toml", "--shard", "1/2", "-o", "a.mp4", "--manifest", "m.json"},
       "--manifest: describes a whole film, but a shard makes only a part of one"},
      {{"render", "s.toml", "--frames", "0", "-o", "a.png", "--manifest", "m.json"},
       "--manifest: possible only for a film or a sequence"},
      {{"render", "s.toml", "-o", "a.mp4", "--format", "mp4"}, "--format: possible only with -o -"},
      {{"still", "s.toml", "-o", "a.png", "--dpi", "300"}, "--dpi needs --width"},
      {{"golden", "--beside"}, "--beside: needs --update"},
      {{"still", "s.toml", "--size"}, "--size: the value is missing; expected WxH"},
      {{"help", "render", "still"}, "help takes one command"},
      {{"new", "a", "--from", "nope"}, "POINSOT_SCENES names the folder of the scenes", 4},
  });
}

TEST_F(ErrorMessages, ExplainInvalidSweeps) {
  put("s.toml", kGoodScene);
  const std::string speeds = "time.speed=0.5..1:3";
  expectAll({
      {{"sweep", "s.toml", "-D", speeds, "--time", "1", "-o", "a.mp4"},
       "--time, --width, --dpi and --type are for one picture, not for a film"},
      {{"sweep", "s.toml", "-D", speeds, "--frames", "1", "-o", "a.png"},
       "are for films; for one picture, use --time"},
      {{"sweep", "s.toml", "-D", "motion.omega_body=[0..1:3, 0..1:3, 1]", "-o", "a.png"},
       "a key may have only one range"},
      {{"sweep", "s.toml", "-D", "time.speed=0.5..1:60", "-D", "time.start=0..1:60", "-o", "a.png"},
       "60 x 60 are 3600 cells: a sweep has at most"},
  });
}

TEST_F(ErrorMessages, ExplainInvalidTimesOfTrajectories) {
  put("s.toml", kGoodScene);
  expectAll({
      {{"trajectory", "s.toml"}, "give either --at T1,T2,... or --rate HZ"},
      {{"trajectory", "s.toml", "--rate", "abc"},
       "--rate 'abc': must be the rows per second of motion, a plain number"},
      {{"trajectory", "s.toml", "-D", "time.speed=1e10", "--rate", "1000000"},
       "rows cannot be distinguished; lower the rate"},
  });
}

// TOML reads \f in double quotes as a form feed, which no font has either. A value given by -D has no columns.
TEST_F(ErrorMessages, AreReportedOncePerCause) {
  put("s.toml", kGoodScene);
  const auto errorOf = [&](const std::string& value) {
    return run(folder_, {"check", "s.toml", "-D", value}).err;
  };
  for (const char* value : {"show.title=\"$\\frac{$\"", "show.title=\xff", "output.size=[100000,100000]"}) {
    const std::string error = errorOf(value);
    EXPECT_THAT(error, HasSubstr(": error: ")) << value;
    EXPECT_EQ(error.find(": error: "), error.rfind(": error: ")) << error;
  }
}

TEST_F(ErrorMessages, ExplainInvalidDiffAndAssemble) {
  put("s.toml", kGoodScene);
  put("a.png", "");
  put("a.mp4", "");
  expectAll({
      {{"diff", "a.png", "."}, "REFERENCE and TEST must both be files or both be folders"},
      {{"diff", "a.png", "a.png", "--curve", "c.svg"}, "--curve: needs two films"},
      {{"diff", "a.png", "a.png", "--max", "0-300"}, "the end of the range must be a number from 0 to 255"},
      {{"diff", "a.png", "a.png", "--max", "3"}, "write 0-3: a limit is a range from 0"},
      {{"assemble", "b.mp4"}, "b.mp4: no segments found", 4},
  });
}

TEST_F(ErrorMessages, ExplainInvalidGoldenSuites) {
  put("s.toml", kGoodScene);
  put("p.png", "");
  const auto says = [&](const std::string& suite, const char* message) {
    put("golden.toml", suite);
    expectAll({{{"golden"}, message}}, {"CI="});
  };
  const std::string test = "[[test]]\nscene = 's.toml'\n";
  says("test = 3\n", "golden.toml:1:8: error: test: expected [[test]] tables, each with its own heading");
  says("size = [64, 48]\n", "expected at least one [[test]], which names pictures to compare");
  says(test + "times = []\n", "expected at least one");
  says(test + "times = [\"soon\"]\n", "expected a film time such as 1.5 or \"90 ms\"");
  says(test + "image = 'p.png'\n", "test: expected either scene or image");
  says("[[test]]\nimage = 'p.png'\ntimes = [1]\n",
       "test: the keys `times` and `set` are allowed only beside `scene`");
  says(test + "name = 'a/.b'\n", "'a/.b': must be a relative path of at most 200 printable characters");
}

TEST_F(ErrorMessages, ExplainInvalidValues) {
  put("s.toml", kGoodScene);
  const auto key = [](const std::string& given) {
    return std::vector<std::string>{"check", "-D", given, "s.toml"};
  };
  expectAll({
      {key("time.duration=1e999 s"), "the number in \"1e999 s\" is out of range"},
      {key("time.duration=1e999"), "the number in \"1e999\" is out of range"},
      {key("time.duration=1 s^x"), "\"s^x\" has an invalid power"},
      {key("style.line_width=1 mm"), "expected a plain number, got \"1 mm\""},
      {key("show.title=$a{b$c}$"), "column 5 of \"$a{b$c}$\": '$' inside braces; close them first"},
      {key("show.title=$\\hat$"), "\\hat needs an argument, such as {x}"},
      {key("show.body.shape=mesh"), "\"mesh\" takes"},
      {key("style.file=https://example.org/a.toml"), "it is a URL; give a path relative to the scene's folder"},
      {key("style.file=../a.toml"), "in the scene's folder or below it, without \"..\""},
      {key("show.title=\xff"), "show.title: is not valid UTF-8, got \"\\xff\"; save the file as UTF-8"},
      {key("timeline=[{caption=\"a\"}]"), "at is required: the film time of this entry"},
  });
}

TEST_F(ErrorMessages, ExplainUnsuitableMotions) {
  put("rest.toml",
      "[body]\nprincipal_moments = [1, 1, 2]\n[motion]\nomega_body = [0, 0, 0]\n"
      "orientation = [1, 0, 0, 0]\n[camera]\nframe = \"precession\"\n");
  put("pushed.toml",
      "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0, 1, 0]\n"
      "[motion.torque]\nbody = [0, 0, 1]\n");
  expectAll({
      {{"check", "rest.toml"}, "a body at rest does not precess"},
      {{"sweep", "pushed.toml", "--map", "-o", "a.png"},
       "the body is not free: leave out gravity, torques and losses"},
  });
}

TEST_F(ErrorMessages, ExplainLoopsThatWouldBeTooLong) {
  put("s.toml", kGoodScene);
  expectAll({{{"check", "-D", "time.loop=true", "-D", "time.speed=1e-4", "s.toml"},
              "more than a film may have; use a time.speed of "}});
}

TEST_F(ErrorMessages, ExplainInvalidPlyHeaders) {
  put("s.toml", "[body]\nshape = \"mesh\"\nfile = \"a.ply\"\nmass = 1\n[motion]\nomega_body = [0, 1, 0]\n");
  put("a.ply", "ply\nelement vertex 3\n");
  expectAll({{{"check", "s.toml"}, "the second line of a PLY file is its format"}});
  put("a.ply", "ply\nformat ascii 1.0\nvertices 3\n");
  expectAll({{{"check", "s.toml"}, "expected element, property, comment or end_header, got \"vertices\""}});
}

}  // namespace
}  // namespace poinsot
