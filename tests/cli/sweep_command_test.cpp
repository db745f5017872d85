// SPDX-License-Identifier: Apache-2.0
// Tests grids and maps through the whole program: equal bytes in every way of rendering, refusals, metadata.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "image/png_file.h"
#include "support/program_run.h"
#include "support/sanitized.h"

namespace poinsot {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string kRange = "motion.omega_body=[0.01..0.05:3, 4, 0]";

class SweepCommand : public ::testing::Test {
 protected:
  void SetUp() override { folder_.put("a.toml", kGoodScene); }

  RunResult sweep(std::vector<std::string> words) {
    words.insert(words.begin(), {"sweep", "a.toml"});
    return run(folder_, words);
  }
  RunResult good(const std::vector<std::string>& words) {
    const auto result = sweep(words);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return result;
  }
  void refused(const std::vector<std::string>& words, const std::string& why) {
    const auto result = sweep(words);
    EXPECT_EQ(result.exitCode, 2) << result.err;
    EXPECT_THAT(result.err, HasSubstr(why));
  }
  std::string bytes(const std::string& name) { return bytesOf(folder_ / name); }

  ScratchFolder folder_;
};

TEST_F(SweepCommand, MakesTheSameFilmWithWorkersSandboxAndResume) {
  const auto film = [&](const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> words{"-D", kRange, "--frames", "0-11", "--segment", "4", "-o", name};
    words.insert(words.end(), more.begin(), more.end());
    return good(words);
  };
  film("one.mp4", {"-j", "1"});
  film("two.mp4", {"-j", "2", "--keep"});
  EXPECT_TRUE(bytes("one.mp4") == bytes("two.mp4"));
  if (!kSanitized) {
    film("three.mp4", {"--untrusted"});
    EXPECT_TRUE(bytes("one.mp4") == bytes("three.mp4"));
  }
  // A missing segment is rendered again with the same bytes.
  std::filesystem::remove(folder_ / "two.mp4");
  std::filesystem::remove(folder_ / ".two.mp4.poinsot/segment-000000004-000000007.mp4");
  EXPECT_THAT(film("two.mp4", {"--resume", "--keep"}).err, HasSubstr("8 of them already existed"));
  EXPECT_TRUE(bytes("one.mp4") == bytes("two.mp4"));
  EXPECT_THAT(film("two.mp4", {"--resume", "--columns", "1"}).err, Not(HasSubstr("already existed")));
  EXPECT_FALSE(bytes("one.mp4") == bytes("two.mp4"));
}

TEST_F(SweepCommand, DrawsASheetLikeTheFrameOfTheFilm) {
  good({"-D", kRange, "--time", "0.1", "-o", "sheet.png"});  // frame 3 at 30 fps
  good({"-D", kRange, "--frames", "2-3", "-o", "f/{frame}.png"});
  EXPECT_TRUE(image::readPng(folder_ / "sheet.png") == image::readPng(folder_ / "f/3.png"));
  EXPECT_FALSE(image::readPng(folder_ / "sheet.png") == image::readPng(folder_ / "f/2.png"));
}

TEST_F(SweepCommand, DrawsInstantsOfOneScene) {
  good({"--times", "0,0.5,1 s", "-D", "time.speed=1", "-o", "list.png", "--size", "300x120"});
  good({"--times", "0..1:3", "-D", "time.speed=1", "-o", "range.png", "--size", "300x120"});
  EXPECT_TRUE(image::readPng(folder_ / "list.png") == image::readPng(folder_ / "range.png"));
  good({"--times", "0,0.5,1", "-D", "time.speed=1", "--label", "time", "--columns", "1", "-o", "sheet.svg"});
  for (const char* label : {">time = 0.0 s</text>", ">time = 0.5 s</text>", ">time = 1.0 s</text>"})
    EXPECT_THAT(bytes("sheet.svg"), HasSubstr(label));
  good({"--times", "0,1", "-D", "motion.omega_body=[1..2:2, 1, 1]", "--dry-run"});
}

TEST_F(SweepCommand, RejectsTimesThatMakeNoSheet) {
  refused({"--times", "0,1", "--time", "1"}, "--times and --time: give only one of them");
  refused({"--times", "0,1", "-D", "time.still=1"}, "--times and -D time.still: give only one of them");
  refused({"--times", "0,1", "-o", "a.mp4"}, "--times: a sheet of several instants is one picture, not a film");
  refused({"--times", "0,1", "-o", "f/{frame}.png"}, "one picture, not a film");
  refused({"--times", "0,1", "--map"}, "--times: makes a sheet of one scene; leave out --map");
  refused({"--times", "0,1", "--series"}, "leave out --series");
  refused({"--times", "0,99"}, "a cell at 99 s: the film lasts from 0 to 4 s");
  refused({"--times", "0,1,1"}, "--times '0,1,1': 1 s comes after 1 s; the times must increase");
  refused({"--times", "2,1"}, "--times '2,1': 1 s comes after 2 s; the times must increase");
  refused({"--times=-1,1"}, "--times '-1,1': -1 s: a film begins at 0 s");
  refused({"--times", "0,nan"}, "a film begins at 0 s");
  refused({"--times", "0,soon"}, "--times 'soon': ");
  refused({"--times", "1"}, "a sheet has from 2 to 100 instants, got 1; for one instant, use --time");
  refused({"--times", "0..x:3"}, "--times '0..x:3': a range is FROM..TO:COUNT");
  refused({"--times", "0..1"}, "--times '0..1': the number of values is missing");
  refused({"--times", ""}, "--times: is empty");
  refused({"--times", "0,1", "-D", "time.speed=1..2:2"}, "-D time.speed: changes the time of the motion");
  refused({"--times", "0,1", "-D", kRange, "-D", "camera.azimuth=0..1:2"}, "one range or two, got 3");
  refused({"-D", "time.still=0|1", "-o", "a.mp4"}, "-D time.still: a sheet of several instants is one picture");
  refused({"-D", "time.still=0|1", "--time", "1"}, "--time: the range of time.still gives each cell its own time");
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.toml"));
}

TEST_F(SweepCommand, NamesPicturesAfterTheSceneByDefault) {
  good({"-D", kRange, "-D", "time.start=0..1 s:2"});
  good({"--map"});
  EXPECT_THAT(namesIn(folder_ / "out"), ElementsAre("a_map.png", "a_sweep.png"));
  const auto description = [&](const char* name) {
    const auto texts = image::textsOfWholePng(folder_ / name);
    if (texts)
      for (const auto& text : *texts)
        if (text.key == "Description") return text.value;
    return std::string();
  };
  EXPECT_THAT(description("out/a_sweep.png"), AllOf(StartsWith("6 pictures of one scene side by side"),
                                                    HasSubstr("from 0.01 rad/s to 0.05 rad/s")));
  EXPECT_THAT(description("out/a_map.png"), StartsWith("A map of how long the body takes from flip to flip"));
}

TEST_F(SweepCommand, WarnsOfTextThatIsTooSmallToRead) {
  const auto said = [&](const std::string& size) {
    return good({"-D", kRange, "-o", "a.png", "--size", size, "--force", "--dry-run"}).err;
  };
  EXPECT_THAT(said("240x135"), HasSubstr("px high, which is too small to read; a larger --size"));
  EXPECT_THAT(said("1280x720"), Not(HasSubstr("too small to read")));
}

TEST_F(SweepCommand, WritesFiguresForPaper) {
  good({"-D", kRange, "-o", "sheet.pdf", "--dpi", "100"});
  good({"--map", "-o", "map.svg", "--dpi", "100"});
  good({"--map", "-o", "map.tex", "--dpi", "100"});
  EXPECT_THAT(bytes("sheet.pdf"), StartsWith("%PDF"));
  EXPECT_THAT(bytes("map.svg"), HasSubstr("A map of how long the body takes from flip to flip"));
}

TEST_F(SweepCommand, RejectsInvalidCombinations) {
  refused({}, "a sweep has one range or two");
  refused({"-D", "time.speed=1..2"}, "a range is FROM..TO:COUNT");
  refused({"-D", "time.speed=1..2:1"}, "a range has from 2 to 100 values, got 1");
  refused({"-D", "time.sped=1..2:2"}, "time.sped: unknown key; did you mean time.speed?");
  refused({"-D", "time.duration=1..2:2"}, "agree in length, rate, size and paper");
  refused({"-D", kRange, "--label", "$\\omgea$"}, "--label");
  refused({"-D", kRange, "-D", "time.loop=true", "-o", "a.mp4"}, "a sweep cannot repeat");
  refused({"-D", kRange, "--map"}, "--map shows one body");
  refused({"--map", "-o", "a.mp4"}, "--map: a map is one picture, not a film");
  refused({"--map", "--columns", "2"}, "--columns and --label are for a grid");
  refused({"-D", kRange, "--frames", "0-3", "-o", "a.png"}, "are for films");
  refused({"-D", kRange, "--time", "1", "-o", "a.mp4"}, "for one picture");
  refused({"--map", "-D", "body.principal_moments=[1, 1, 1.5]"}, "never flips");
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.toml"));
}

// All cells together have the limit of triangles of one scene.
TEST_F(SweepCommand, CellsShareTheLimitsOfAScene) {
  folder_.put("t.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  folder_.put(
      "a.toml",
      "[body]\n[[body.part]]\nshape = 'mesh'\nfile = 't.obj'\nmass = 1\n[motion]\nomega_body = [0.1, 4, 0]\n"
      "[output]\nsize = [160, 90]\n");
  good({"-D", "time.start=0..1:3", "--limit", "triangles=12", "--dry-run"});
  refused({"-D", "time.start=0..1:3", "--limit", "triangles=11", "--dry-run"}, "triangles");
}

// Oracle: `render -D` of each value.
TEST_F(SweepCommand, MakesASeriesOfTheFilmsThatRenderMakes) {
  const std::vector<std::string> series{"--series", "-D", kRange, "-o", "f{value}.mp4", "--frames", "0-5"};
  const auto made = good(series);
  for (const char* value : {"0.01", "0.03", "0.05"}) {
    const std::string name = std::string("f") + value + ".mp4";
    EXPECT_THAT(made.err, HasSubstr("poinsot: " + name + " is ready (6 frames, "));
    const auto alone = run(folder_, {"render", "a.toml", "-o", "one.mp4", "--frames", "0-5", "-D",
                                     std::string("motion.omega_body=[") + value + ", 4, 0]"});
    EXPECT_EQ(alone.exitCode, 0) << alone.err;
    EXPECT_TRUE(bytes(name) == bytes("one.mp4")) << name;
  }
  std::filesystem::remove(folder_ / "f0.03.mp4");
  const auto again = good(series);
  EXPECT_THAT(again.err, HasSubstr("f0.01.mp4 is ready (6 frames, 6 of them already existed"));
  EXPECT_THAT(again.err, HasSubstr("f0.03.mp4 is ready (6 frames, "));
  EXPECT_THAT(again.err, Not(HasSubstr("f0.03.mp4 is ready (6 frames, 6 of them")));
}

TEST_F(SweepCommand, SharesTheFilmsOfASeriesBetweenShards) {
  const auto shard = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"--series", "-D", kRange, "-o", "f{value}.mp4", "--frames", "0-2"};
    words.insert(words.end(), more.begin(), more.end());
    return sweep(words);
  };
  EXPECT_EQ(shard({"--shards-left", "2"}).out, "1-2\n");
  EXPECT_EQ(shard({"--shard", "2/2"}).exitCode, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "f0.03.mp4"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "f0.01.mp4"));
  const auto left = shard({"--shards-left", "2"});
  EXPECT_EQ(left.exitCode, 1);
  EXPECT_EQ(left.out, "1\n");
  EXPECT_EQ(shard({"--shard", "1/2"}).exitCode, 0);
  EXPECT_EQ(shard({"--shard", "4/4"}).exitCode, 0);  // has no film
  const auto none = shard({"--shards-left", "2"});
  EXPECT_EQ(none.exitCode, 0);
  EXPECT_EQ(none.err, "poinsot: all 3 films are complete\n");
}

TEST_F(SweepCommand, MakesASeriesOfPicturesOrSequences) {
  good({"--series", "-D", kRange, "-o", "p{value}.png"});
  good({"--series", "-D", kRange, "-o", "s{value}_{frame:02}.png", "--frames", "3-4"});
  for (const char* value : {"0.01", "0.03", "0.05"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_ / (std::string("p") + value + ".png")));
    EXPECT_TRUE(std::filesystem::exists(folder_ / (std::string("s") + value + "_04.png")));
  }
}

TEST_F(SweepCommand, RejectsOptionsThatASeriesCannotHave) {
  refused({"-D", kRange, "-o", "{value}.mp4"},
          "-o: {value} stands for a value in the names of a series; add --series");
  refused({"--series", "-D", kRange}, "--series: needs names for the films");
  refused({"--series", "-D", kRange, "-o", "a.mp4"}, "write {value} in the name");
  refused({"--series", "-D", kRange, "-o", "{value}.mp4", "--map"}, "leave out --map, --columns and --label");
  refused({"--series", "-D", kRange, "-o", "{value}.mp4", "--manifest", "m.json"}, "--manifest and --trace");
  refused({"--series", "-D", kRange, "-o", "{value}.png", "--shard", "1/2"},
          "--shard and --manifest are for films");
  // The error of one film is reported before any film is made.
  refused({"--series", "-D", "time.duration=1|2|-1", "-o", "{value}.mp4"}, "time.duration");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "1.mp4"));
}

}  // namespace
}  // namespace poinsot
