// SPDX-License-Identifier: Apache-2.0
// What is refused of the command line and of files, each with its sentence and with nothing made. What a message
// has to say is written here by hand, from what the user has to know to mend it.
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

class Refused : public testing::Test {
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

TEST_F(Refused, NamesOfWhatIsMade) {
  put("s.toml", kGoodScene);
  std::filesystem::create_directory(folder_ / "full.png");
  expectAll({
      {{"render", "s.toml", "-o", "out/"}, "output 'out/': not a file name; works: NAME.mp4"},
      {{"render", "s.toml", "-o", "a_{frame}.mp4"}, "a film is one file and has no {frame}"},
      {{"render", "s.toml", "-o", "a_{frame}_{frame}.png"}, "more than one pair of braces"},
      {{"render", "s.toml", "-o", "a_{x}.png"}, "not a frame number: {x}"},
      {{"render", "s.toml", "-o", "a_{frame}/b.png"}, "the frame number is in the folder's name"},
      {{"render", "s.toml", "-o", "a.png"},
       "a.png takes one frame, and 120 are selected: choose one with --frames 0"},
      {{"still", "s.toml", "-o", "full.png", "--force"},
       "full.png: is a folder; outputs are written to regular files",
       4},
      {{"submit", "s.toml", "-o", "-", "--format", "mp4"}, "-o -: tasks on several machines write files"},
      {{"render", "s.toml", "-o", "a.mp4", "--trace", "a.mp4"}, "--trace a.mp4 is the same file as -o a.mp4"},
  });
}

TEST_F(Refused, OptionsThatDoNotBelongTogether) {
  put("s.toml", kGoodScene);
  put("golden.toml", "[[test]]\nscene = 's.toml'\n");
  expectAll({
      {{"render", "s.toml", "--shard", "3/2", "-o", "a.mp4"}, "--shard '3/2': a shard is k/n, such as 2/7"},
      {{"render", "s.toml", "--shard", "1/2", "-o", "a.mp4", "--manifest", "m.json"},
       "--manifest: tells of a whole film, and a shard makes a part of one"},
      {{"render", "s.toml", "--frames", "0", "-o", "a.png", "--manifest", "m.json"},
       "--manifest: is of a film or a sequence"},
      {{"render", "s.toml", "-o", "a.mp4", "--format", "mp4"}, "--format goes with -o -"},
      {{"still", "s.toml", "-o", "a.png", "--dpi", "300"}, "--dpi needs --width"},
      {{"golden", "--beside"}, "--beside: goes with --update"},
      {{"still", "s.toml", "--size"}, "--size: its value is missing, WxH"},
      {{"help", "render", "still"}, "help takes one command"},
      {{"new", "a", "--from", "nope"}, "POINSOT_SCENES names the folder of the scenes", 4},
  });
}

TEST_F(Refused, Sweeps) {
  put("s.toml", kGoodScene);
  const std::string speeds = "time.speed=0.5..1:3";
  expectAll({
      {{"sweep", "s.toml", "-D", speeds, "--time", "1", "-o", "a.mp4"},
       "--time, --width and --dpi are for one picture, not for a film"},
      {{"sweep", "s.toml", "-D", speeds, "--frames", "1", "-o", "a.png"}, "are for films; one picture has --time"},
      {{"sweep", "s.toml", "-D", "motion.omega_body=[0..1:3, 0..1:3, 1]", "-o", "a.png"}, "one range in a key"},
      {{"sweep", "s.toml", "-D", "time.speed=0.5..1:60", "-D", "time.start=0..1:60", "-o", "a.png"},
       "60 x 60 are 3600 cells: a sweep has at most"},
  });
}

TEST_F(Refused, TimesOfTrajectories) {
  put("s.toml", kGoodScene);
  expectAll({
      {{"trajectory", "s.toml"}, "say at which times: --at T1,T2,... or --rate HZ"},
      {{"trajectory", "s.toml", "--rate", "abc"}, "--rate 'abc': rows per second of motion: a plain number"},
      {{"trajectory", "s.toml", "-D", "time.speed=1e10", "--rate", "1000000"},
       "rows are more than can be told apart"},
  });
}

// TOML reads \f in double quotes as a form feed, which no font has either; a value given by -D has no columns.
TEST_F(Refused, WithOneErrorForOneCause) {
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

TEST_F(Refused, WhatIsNotComparedOrJoined) {
  put("s.toml", kGoodScene);
  put("a.png", "");
  put("a.mp4", "");
  expectAll({
      {{"diff", "a.png", "."}, "both must be files, or both folders"},
      {{"diff", "a.png", "a.png", "--curve", "c.svg"}, "--curve: needs two films"},
      {{"diff", "a.png", "a.png", "--max", "0-300"}, "the end of the range must be a number from 0 to 255"},
      {{"diff", "a.png", "a.png", "--max", "3"}, "write 0-3: a limit is a range from 0"},
      {{"assemble", "b.mp4"}, "b.mp4: there are no segments of it here", 4},
  });
}

TEST_F(Refused, SuitesOfGoldenImages) {
  put("s.toml", kGoodScene);
  put("p.png", "");
  const auto says = [&](const std::string& suite, const char* message) {
    put("golden.toml", suite);
    expectAll({{{"golden"}, message}}, {"CI="});
  };
  const std::string test = "[[test]]\nscene = 's.toml'\n";
  says("test = 3\n", "golden.toml:1:8: error: test: expected [[test]], each with a heading of its own");
  says("size = [64, 48]\n", "expected [[test]], the pictures to compare");
  says(test + "times = []\n", "expected at least one");
  says(test + "times = [\"soon\"]\n", "expected a film time such as 1.5 or \"90 ms\"");
  says(test + "image = 'p.png'\n", "test: expected a scene or an image, one of the two");
  says("[[test]]\nimage = 'p.png'\ntimes = [1]\n", "test: times and set are for a scene");
  says(test + "name = 'a/.b'\n", "'a/.b': a name must be that of a file below the references");
}

TEST_F(Refused, Quantities) {
  put("s.toml", kGoodScene);
  const auto key = [](const std::string& given) {
    return std::vector<std::string>{"check", "-D", given, "s.toml"};
  };
  expectAll({
      {key("time.duration=1e999 s"), "the number in \"1e999 s\" is out of range"},
      {key("time.duration=1e999"), "the number in \"1e999\" is out of range"},
      {key("time.duration=1 s^x"), "the power in \"s^x\" is not understood"},
      {key("style.line_width=1 mm"), "expected a plain number, got \"1 mm\""},
      {key("show.title=$a{b$c}$"), "column 5 of \"$a{b$c}$\": '$' inside braces; close them first"},
      {key("show.title=$\\hat$"), "\\hat needs an argument, such as {x}"},
      {key("show.body.shape=mesh"), "\"mesh\" takes"},
      {key("style.file=https://example.org/a.toml"), "it is an address; a scene names files by their paths"},
      {key("style.file=../a.toml"), "in the scene's folder or below it, without \"..\""},
      {key("show.title=\xff"), "show.title: not UTF-8, got \"\\xff\"; save the file with that encoding"},
      {key("timeline=[{caption=\"a\"}]"), "at is required: the film time at which it happens"},
  });
}

TEST_F(Refused, WhatAMotionLacks) {
  put("rest.toml",
      "[body]\nprincipal_moments = [1, 1, 2]\n[motion]\nomega_body = [0, 0, 0]\n"
      "orientation = [1, 0, 0, 0]\n[camera]\nframe = \"precession\"\n");
  put("pushed.toml",
      "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0, 1, 0]\n"
      "[motion.torque]\nbody = [0, 0, 1]\n");
  expectAll({
      {{"check", "rest.toml"}, "a body at rest does not precess"},
      {{"sweep", "pushed.toml", "--map", "-o", "a.png"}, "the body is not free: leave out what acts on it"},
  });
}

TEST_F(Refused, LoopsThatWouldBeTooLong) {
  put("s.toml", kGoodScene);
  expectAll({{{"check", "-D", "time.loop=true", "-D", "time.speed=1e-4", "s.toml"},
              "more than a film may have; a time.speed of "}});
}

TEST_F(Refused, MeshesOfNoKnownForm) {
  put("s.toml", "[body]\nshape = \"mesh\"\nfile = \"a.ply\"\nmass = 1\n[motion]\nomega_body = [0, 1, 0]\n");
  put("a.ply", "ply\nelement vertex 3\n");
  expectAll({{{"check", "s.toml"}, "the second line of a PLY file is its format"}});
  put("a.ply", "ply\nformat ascii 1.0\nvertices 3\n");
  expectAll({{{"check", "s.toml"}, "expected element, property, comment or end_header, got \"vertices\""}});
}

}  // namespace
}  // namespace poinsot
