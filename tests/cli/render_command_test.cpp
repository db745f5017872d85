// SPDX-License-Identifier: Apache-2.0
// Tests tiny renders through the whole program: bytes, targets, streams, signals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "image/png_file.h"
#include "support/back_ends.h"
#include "support/program_run.h"
#include "support/shell_run.h"

namespace poinsot {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class RenderCommand : public ::testing::Test {
 protected:
  void SetUp() override { folder_.put("a.toml", kGoodScene); }

  RunResult good(const std::vector<std::string>& words) {
    auto result = run(folder_, words);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.out, IsEmpty());
    return result;
  }

  std::string bytes(const std::string& name) { return bytesOf(folder_ / name); }

  ScratchFolder folder_;
};

TEST_F(RenderCommand, WritesTheSameBytesWithAnyNumberOfWorkers) {
  good({"render", "a.toml", "-o", "one.mp4", "-j", "1"});
  good({"render", "a.toml", "-o", "two.mp4", "-j", "2"});
  good({"render", "a.toml", "-o", "seven.mp4", "-j", "7"});  // more workers than segments
  EXPECT_GT(bytes("one.mp4").size(), 10000u);
  EXPECT_TRUE(bytes("one.mp4") == bytes("two.mp4"));
  EXPECT_TRUE(bytes("one.mp4") == bytes("seven.mp4"));
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.toml", "one.mp4", "seven.mp4", "two.mp4"));
}

// File names are bytes that need not be UTF-8; text that contains a name is UTF-8 all the same.
TEST_F(RenderCommand, AcceptsFileNamesThatAreNotUtf8) {
  folder_.put("\xe9\xff.toml", kGoodScene);
  good({"render", "\xe9\xff.toml", "--frames", "0-1", "-o", "\xff.mp4", "--manifest", "m.json"});
  good({"render", "\xe9\xff.toml", "--frames", "0-1", "-o", "\xff_{frame}.png"});
  good({"render", "\xe9\xff.toml", "--frames", "0", "-o", "\xfe.png"});
  EXPECT_EQ(nlohmann::json::parse(bytes("m.json"))["title"], "\\xe9\\xff");
  EXPECT_EQ(image::textsOfWholePng(folder_ / "\xfe.png").value().at(1).value, "\\xe9\\xff");
}

TEST_F(RenderCommand, StillEqualsTheFrameAtItsTime) {
  good({"render", "a.toml", "-o", "frames/a_{frame:04}.png", "--frames", "58-61", "-j", "2"});
  EXPECT_THAT(namesIn(folder_ / "frames"), ElementsAre("a_0058.png", "a_0059.png", "a_0060.png", "a_0061.png"));
  good({"render", "a.toml", "--frames", "60", "-o", "frame.png"});
  // Labels are hidden, because they may fade in a film and not in a still. 2 s at 30 fps is frame 60.
  good({"still", "a.toml", "--time", "2", "-D", "show.labels=false", "-o", "still.png"});
  good({"render", "a.toml", "--frames", "60", "-D", "show.labels=false", "-o", "bare_frame.png"});
  EXPECT_TRUE(bytes("still.png") == bytes("bare_frame.png"));
  // Compares pixels only, because a single picture has a description.
  const auto picture = [&](const char* name) { return image::readPng(folder_ / name); };
  EXPECT_TRUE(picture("frame.png") == picture("frames/a_0060.png"));
  EXPECT_FALSE(picture("frame.png") == picture("frames/a_0061.png"));
}

TEST_F(RenderCommand, StillBetweenTwoFramesDiffersFromBoth) {
  good({"still", "a.toml", "--time", "1.0", "-o", "before.png"});
  good({"still", "a.toml", "--time", "1.016", "-o", "between.png"});
  good({"still", "a.toml", "--time", "1.0333333333333333", "-o", "after.png"});
  EXPECT_FALSE(bytes("between.png") == bytes("before.png"));
  EXPECT_FALSE(bytes("between.png") == bytes("after.png"));
}

TEST_F(RenderCommand, WritesSixteenBitsIfRequested) {
  // Returns the pixel format that ffprobe reports; PNG is big-endian.
  const auto kind = [&](const std::string& name) {
    return runShell(folder_.path(), "ffprobe -v error -show_entries stream=pix_fmt -of csv=p=0 " + name).out;
  };
  good({"still", "a.toml", "--time", "2", "--bits", "16", "-o", "deep.png"});
  EXPECT_EQ(kind("deep.png"), "rgb48be\n");
  good({"still", "a.toml", "--time", "2", "--bits", "16", "--transparent", "-o", "clear.png"});
  EXPECT_EQ(kind("clear.png"), "rgba64be\n");
  good({"still", "a.toml", "--time", "2", "--bits", "8", "-o", "eight.png"});
  EXPECT_EQ(kind("eight.png"), "rgb24\n");
  good({"still", "a.toml", "--time", "2", "-o", "plain.png"});
  EXPECT_TRUE(bytes("eight.png") == bytes("plain.png"));
  for (const std::string& backEnd : backEndNames()) {
    good({"still", "a.toml", "--time", "2", "--bits", "16", "--backend", backEnd, "-o", "by.png", "--force"});
    EXPECT_TRUE(bytes("by.png") == bytes("deep.png")) << backEnd;
  }
  // Rounded to 8 bits, the picture equals the picture of 8 bits.
  const image::Image deep = image::readPng(folder_ / "deep.png"), eight = image::readPng(folder_ / "eight.png");
  ASSERT_EQ(deep.size, eight.size);
  ASSERT_EQ(deep.channels, 3);
  for (std::size_t i = 0; i < deep.pixels.size(); ++i) ASSERT_NEAR(deep.pixels[i], eight.pixels[i], 1) << i;
}

TEST_F(RenderCommand, WritesTheSame16BitSequenceWithWorkersAndResume) {
  const std::vector<std::string> names{"0058.png", "0059.png", "0060.png", "0061.png"};
  const auto render = [&](const std::string& folder, std::vector<std::string> more) {
    std::vector<std::string> words{"render", "a.toml", "--frames", "58-61", "-o", folder + "/{frame:04}.png"};
    words.insert(words.end(), more.begin(), more.end());
    return good(words);
  };
  const auto expectSame = [&](const std::string& a, const std::string& b) {
    for (const auto& name : names) EXPECT_TRUE(bytes(a + "/" + name) == bytes(b + "/" + name)) << b << name;
  };
  render("one", {"--bits", "16", "-j", "1"});
  render("two", {"--bits", "16", "-j", "2"});
  expectSame("one", "two");
  // Existing frames are kept; a missing frame is rendered again with the same bytes.
  std::filesystem::remove(folder_ / "two/0059.png");
  EXPECT_THAT(render("two", {"--bits", "16", "--resume"}).err, HasSubstr("3 of them already existed"));
  expectSame("one", "two");
  // Frames of 8 bits are not reused for 16 bits, nor the reverse.
  EXPECT_THAT(render("two", {"--resume"}).err, Not(HasSubstr("already existed")));
  EXPECT_FALSE(bytes("one/0060.png") == bytes("two/0060.png"));
  EXPECT_THAT(render("two", {"--bits", "16", "--resume"}).err, Not(HasSubstr("already existed")));
  expectSame("one", "two");
}

TEST_F(RenderCommand, BackEndsDrawTheSameBytes) {
  POINSOT_NEEDS_OSMESA();
  good({"still", "a.toml", "--backend", "osmesa", "-o", "osmesa.png"});
  good({"still", "a.toml", "--backend", "egl", "-o", "egl.png"});
  EXPECT_TRUE(bytes("osmesa.png") == bytes("egl.png"));
}

TEST_F(RenderCommand, AcceptsOddSizesForPictures) {
  good({"still", "a.toml", "--size", "161x91", "-o", "odd.png"});
  const auto picture = image::readPng(folder_ / "odd.png");
  EXPECT_EQ(picture.size, (image::PixelSize{161, 91}));
}

TEST_F(RenderCommand, QualityOptionOverridesTheScene) {
  good({"still", "a.toml", "-q", "preview", "-o", "preview.png"});
  EXPECT_EQ(image::readPng(folder_ / "preview.png").size, (image::PixelSize{640, 360}));
}

TEST_F(RenderCommand, CreatesTheFolderOutIfNeeded) {
  good({"render", "a.toml", "--frames", "0", "-o", "out/x.png"});
  EXPECT_GT(bytes("out/x.png").size(), 500u);
}

TEST_F(RenderCommand, WritesToTheFolderOutByDefault) {
  good({"still", "a.toml"});
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.toml", "out"));
  EXPECT_THAT(namesIn(folder_ / "out"), ElementsAre("a.png"));
}

TEST_F(RenderCommand, ReplacesItsOwnOutputButNoForeignFile) {
  good({"still", "a.toml", "-o", "a.png"});
  good({"still", "a.toml", "-o", "a.png", "--time", "1"});
  good({"render", "a.toml", "-o", "a.mp4", "--frames", "0-3"});
  good({"render", "a.toml", "-o", "a.mp4", "--frames", "0-3"});
  for (const std::string name : {"mine.png", "mine.mp4"}) {
    folder_.put(name, "not a picture");
    const auto refused = run(folder_, {"render", "a.toml", "--frames", "0", "-o", name});
    EXPECT_EQ(refused.exitCode, 4);
    EXPECT_THAT(refused.err, HasSubstr(name + ": exists and was not written by poinsot; --force replaces it"));
    EXPECT_EQ(bytes(name), "not a picture");
    good({"render", "a.toml", "--frames", "0", "-o", name, "--force"});
    EXPECT_GT(bytes(name).size(), 500u);
  }
}

TEST_F(RenderCommand, ReportsWhatALoopChanges) {
  const auto result = run(folder_, {"render", "a.toml", "--loop", "--dry-run"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("the film repeats after "));
  EXPECT_THAT(result.err, HasSubstr("omega at the start changed by "));
  EXPECT_EQ(run(folder_, {"render", "a.toml", "--loop", "--dry-run", "--quiet"}).err, "");
  EXPECT_THAT(run(folder_, {"render", "a.toml", "--loop", "-D", "motion.drag.rate=0.1", "--dry-run"}).err,
              HasSubstr("--loop: error: time.loop: something acts on the body"));
}

TEST_F(RenderCommand, ReportsTheChosenPace) {
  const auto said = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"render", "top.toml", "--dry-run"};
    words.insert(words.end(), more.begin(), more.end());
    return run(folder_, words).err;
  };
  folder_.put("top.toml",
              "[body]\nprincipal_moments = [1, 1, 2]\n[motion]\nomega_body = [0, 0, 100]\n"
              "orientation = [0.966, 0.259, 0, 0]\ngravity.mgr_body = [0, 0, 5]\n");
  // A fast top precesses at M g l/(I3 omega_3) and nutates at I3 omega_3/I1 (Landau & Lifshitz, section 35,
  // problem 3). The precession is 0.025 rad/s, half a radian in 20 s of film. The nutation takes 2 pi/200 s, 1.57
  // ms of film.
  EXPECT_EQ(said({}),
            "poinsot: a second of film is 20 s of the motion, the whole film 200 s; a nutation takes 0.00157 s of "
            "film; time.speed = 1 shows the motion in real time\n");
  EXPECT_EQ(said({"-D", "time.speed=5"}), "");
  EXPECT_EQ(
      said({"-D", "time.speed=0.02"}),
      "-D time.speed=0.02: note: time.speed: the film shows 0.0008 of a turn of the top's precession, which goes "
      "round once in 251 s; time.speed = 25.1 shows a whole turn in these 10 s of film\n");
  EXPECT_EQ(said({"-D", "motion.gravity.mgr_body=[1, 0, 5]"}),
            "poinsot: a second of film is 20 s of the motion, the whole film 200 s; time.speed = 1 shows the "
            "motion in real time\n");
}

TEST_F(RenderCommand, RejectsASequenceThatWouldReplaceAForeignFile) {
  good({"render", "a.toml", "--frames", "0-1", "-o", "s_{frame}.png"});
  const auto earlier = bytes("s_0.png");
  folder_.put("s_2.png", "mine");
  const auto refused = run(folder_, {"render", "a.toml", "--frames", "0-2", "-o", "s_{frame}.png", "--fps", "10"});
  EXPECT_EQ(refused.exitCode, 4);
  EXPECT_TRUE(bytes("s_0.png") == earlier);
  EXPECT_EQ(bytes("s_2.png"), "mine");
}

TEST_F(RenderCommand, ExitsWith4ForPathsThatCannotBeWritten) {
  std::filesystem::create_directory(folder_ / "d.mp4");
  for (const char* target : {"no/such/a.mp4", "d.mp4", "a.toml/a.mp4"}) {
    const auto result = run(folder_, {"render", "a.toml", "-o", target});
    EXPECT_EQ(result.exitCode, 4) << target << "\n" << result.err;
    EXPECT_THAT(result.err, HasSubstr("poinsot: error: "));
  }
}

TEST_F(RenderCommand, WritesNothingInADryRun) {
  const auto dry = run(folder_, {"render", "a.toml", "--dry-run", "--frames", "30-119"});
  EXPECT_EQ(dry.exitCode, 0) << dry.err;
  EXPECT_EQ(dry.out, "out/a.mp4: 90 frames (30-119), 160x90, 30/1 frames/s, 3 segments\n");
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.toml"));
}

TEST_F(RenderCommand, QuietPrintsNothing) {
  EXPECT_THAT(good({"render", "a.toml", "--quiet", "--frames", "0-3", "-o", "a.mp4"}).err, IsEmpty());
}

TEST_F(RenderCommand, PrintsOneJsonObjectPerLineOfProgress) {
  std::istringstream lines(good({"render", "a.toml", "--progress=json", "-o", "a.mp4"}).err);
  nlohmann::json last;
  for (std::string line; std::getline(lines, line);) last = nlohmann::json::parse(line);
  EXPECT_EQ(last.at("event"), "progress");
  EXPECT_EQ(last.at("done"), 120);
  EXPECT_EQ(last.at("total"), 120);
}

TEST_F(RenderCommand, PrintsStatsPerStep) {
  const auto result = good({"render", "a.toml", "--stats", "--frames", "0-9", "-o", "a.mp4"});
  for (const char* said : {"10 frames in", "simulate", "compose", "draw", "resolve", "read", "text", "convert",
                           "encode", "write", "peak memory"})
    EXPECT_THAT(result.err, HasSubstr(said));
}

struct TracedSpan {
  double begin_us, end_us;
  std::string name;
  int frame;  // -1 if the span has no frame
};

/// Spans by process and row, in order of time; an enclosing span precedes the spans inside it.
using TracedRows = std::map<std::pair<int, int>, std::vector<TracedSpan>>;

TracedRows rowsOf(const nlohmann::json& trace) {
  TracedRows rows;
  for (const auto& event : trace.at("traceEvents")) {
    if (event.at("ph") != "X") continue;
    const double begin_us = event.at("ts"), end_us = begin_us + event.at("dur").get<double>();
    rows[{event.at("pid"), event.at("tid")}].push_back(
        {begin_us, end_us, event.at("name"), event.at("args").value("frame", -1)});
  }
  for (auto& [key, row] : rows)
    std::ranges::sort(row, [](const TracedSpan& a, const TracedSpan& b) {
      return std::pair(a.begin_us, -a.end_us) < std::pair(b.begin_us, -b.end_us);
    });
  return rows;
}

/// Returns the sum of the outermost spans, and expects all other spans to lie inside one of them.
double outermost_us(const std::vector<TracedSpan>& row) {
  constexpr double kRounding_us = 1e-3;
  double sum_us = 0, end_us = 0;
  for (const TracedSpan& span : row) {
    if (span.begin_us < end_us - kRounding_us) {
      EXPECT_LE(span.end_us, end_us + kRounding_us) << span.name << " of frame " << span.frame;
      continue;
    }
    sum_us += span.end_us - span.begin_us;
    end_us = span.end_us;
  }
  return sum_us;
}

TEST_F(RenderCommand, TracesEveryFrameOfEveryWorker) {
  const std::vector<std::string> arguments{"render", "a.toml", "--frames", "0-11", "--segment", "3", "-j", "2"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), arguments.begin(), arguments.end());
    good(more);
  };
  with({"-o", "plain.mp4"});
  with({"-o", "a.mp4", "--trace", "trace.json"});
  EXPECT_TRUE(bytes("plain.mp4") == bytes("a.mp4"));
  const auto text = bytes("trace.json");
  const auto trace = nlohmann::json::parse(text.begin(), text.end());
  std::map<std::string, std::multiset<int>> framesOf;
  double wall_us = 0;
  const TracedRows rows = rowsOf(trace);
  for (const auto& [key, row] : rows)
    for (const TracedSpan& span : row) {
      wall_us = std::max(wall_us, span.end_us);
      if (span.frame >= 0) framesOf[span.name].insert(span.frame);
    }
  std::multiset<int> all;
  for (int k = 0; k < 12; ++k) all.insert(k);
  for (const char* step : {"simulate", "compose", "draw", "resolve", "read", "text", "convert", "encode"})
    EXPECT_EQ(framesOf[step], all) << step;
  EXPECT_EQ(framesOf["segment"], (std::multiset<int>{0, 3, 6, 9}));
  for (const auto& [key, row] : rows) EXPECT_LE(outermost_us(row), wall_us) << key.first << " " << key.second;
  EXPECT_EQ(rows.at({0, 1}).back().name, "assemble");
  EXPECT_TRUE(rows.contains({1, 2}) && rows.contains({2, 2}));
}

TEST_F(RenderCommand, RejectsAnUnwritableTraceBeforeRendering) {
  folder_.put("mine.json", "{}");
  const auto refused = [&](const std::string& trace, int exitCode, const std::string& said) {
    const auto result = run(folder_, {"render", "a.toml", "-o", "a.mp4", "--trace", trace});
    EXPECT_EQ(result.exitCode, exitCode) << trace;
    EXPECT_THAT(result.err, HasSubstr(said));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.mp4"));
  };
  refused("none/trace.json", 4, "none: no such folder");
  refused("mine.json", 4, "was not written by poinsot");
  refused("./a.mp4", 2, "--trace");
}

TEST_F(RenderCommand, IgnoresEditsOfTheSceneWhileItRuns) {
  good({"render", "a.toml", "-o", "calm.mp4", "-j", "2"});
  ProgramRun running(folder_, {"render", "a.toml", "-o", "edited.mp4", "-j", "2", "--progress=json"});
  while (running.errSoFar().empty()) usleep(2000);
  folder_.put("a.toml", "not a scene at all");
  EXPECT_EQ(running.wait().exitCode, 0);
  EXPECT_TRUE(bytes("calm.mp4") == bytes("edited.mp4"));
}

double seconds(std::chrono::steady_clock::duration time) { return std::chrono::duration<double>(time).count(); }

class Signals : public RenderCommand, public ::testing::WithParamInterface<std::pair<int, int>> {};

TEST_P(Signals, EndARenderWithoutLeavingFiles) {
  const auto [signal, exitCode] = GetParam();
  // The film has far more frames than can be rendered before the signal.
  ProgramRun running(
      folder_, {"render", "a.toml", "-D", "time.duration=1000", "-o", "long.mp4", "-j", "2", "--progress=json"});
  while (running.errSoFar().empty()) usleep(2000);
  EXPECT_TRUE(std::filesystem::exists(folder_ / ".long.mp4.poinsot"));
  const auto sent = std::chrono::steady_clock::now();
  running.signal(signal);
  EXPECT_EQ(running.wait().exitCode, exitCode);
  EXPECT_LT(seconds(std::chrono::steady_clock::now() - sent), 2.0);
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.toml"));
}

INSTANTIATE_TEST_SUITE_P(Each, Signals,
                         ::testing::Values(std::pair{SIGINT, 130}, std::pair{SIGTERM, 143},
                                           std::pair{SIGHUP, 129}));

// `timeout -s INT` sends the signal to the program and at once to its process group, which includes the program.
TEST_F(RenderCommand, EndsCleanlyIfASignalArrivesTwice) {
  ProgramRun running(
      folder_, {"render", "a.toml", "-D", "time.duration=1000", "-o", "long.mp4", "-j", "2", "--progress=json"});
  while (running.errSoFar().empty()) usleep(2000);
  kill(running.pid(), SIGINT);
  kill(-running.pid(), SIGINT);
  EXPECT_EQ(running.wait().exitCode, 130);
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.toml"));
}

std::vector<pid_t> childrenOf(pid_t parent) {
  std::vector<pid_t> children;
  std::istringstream list(
      bytesOf("/proc/" + std::to_string(parent) + "/task/" + std::to_string(parent) + "/children"));
  for (pid_t child = 0; list >> child;) children.push_back(child);
  return children;
}

/// Returns whether the process runs. A zombie does not.
bool alive(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string text;
  std::getline(file, text);
  return file && text.at(text.rfind(')') + 2) != 'Z';
}

TEST_F(RenderCommand, ReportsTheFramesOfADeadWorker) {
  // No segment is complete before the worker dies; a complete segment would be kept.
  ProgramRun running(folder_, {"render", "a.toml", "-D", "time.duration=1000", "-o", "long.mp4", "-j", "2",
                               "--segment", "1000", "--progress=json"});
  while (running.errSoFar().empty()) usleep(2000);
  const auto workers = childrenOf(running.pid());
  ASSERT_EQ(workers.size(), 2u);
  kill(workers[1], SIGKILL);
  const auto result = running.wait();
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_THAT(result.err, HasSubstr("a worker process was killed by signal 9 (Killed) while making frames "));
  EXPECT_FALSE(alive(workers[0]));
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.toml"));
}

TEST_F(RenderCommand, WorkersEndWithTheirParentAndTheNextRunTakesOver) {
  {
    ProgramRun running(
        folder_, {"render", "a.toml", "-D", "time.duration=1000", "-o", "a.mp4", "-j", "2", "--progress=json"});
    while (running.errSoFar().empty()) usleep(2000);
    const auto workers = childrenOf(running.pid());
    ASSERT_EQ(workers.size(), 2u);
    running.signal(SIGKILL);
    EXPECT_EQ(running.wait().exitCode, 1000 + SIGKILL);
    for (int i = 0; i < 500 && (alive(workers[0]) || alive(workers[1])); ++i) usleep(10000);
    EXPECT_FALSE(alive(workers[0]) || alive(workers[1]));
  }
  EXPECT_TRUE(std::filesystem::exists(folder_ / ".a.mp4.poinsot"));
  good({"render", "a.toml", "-o", "a.mp4", "--frames", "0-3"});
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.mp4", "a.toml"));
}

TEST_F(RenderCommand, RejectsASecondRenderOfTheSameOutput) {
  ProgramRun first(folder_, {"render", "a.toml", "-D", "time.duration=1000", "-o", "a.mp4", "--progress=json"});
  while (first.errSoFar().empty()) usleep(2000);
  const auto second =
      run(ScratchFolder(), {"render", (folder_ / "a.toml").string(), "-o", (folder_ / "a.mp4").string()});
  EXPECT_EQ(second.exitCode, 4);
  EXPECT_THAT(second.err, HasSubstr("another poinsot is making this output now"));
}

}  // namespace
}  // namespace poinsot
