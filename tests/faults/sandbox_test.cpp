// SPDX-License-Identifier: Apache-2.0
// --untrusted gives the same bytes and prevents every other action (row B1 of the promises in SECURITY.md).
#include <gmock/gmock.h>
#include <signal.h>
#include <unistd.h>

#include <regex>
#include <set>

#include "faults/tiny_film.h"
#include "support/sanitized.h"

namespace poinsot::faults {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> untrusted(std::vector<std::string> arguments) {
  arguments.emplace_back("--untrusted");
  return arguments;
}

class Sandboxed : public testing::Test {
 protected:
  void SetUp() override {
    if (kSanitized) GTEST_SKIP() << "the sandbox bounds the address space, and lets no process look at another";
    folder_.put("tiny.toml", kTinyScene);
  }

  std::vector<std::string> environment(std::vector<std::string> more = {}) const {
    more.push_back("TMPDIR=" + temporary_.path().string());
    return more;
  }

  RunResult runIn(const std::vector<std::string>& arguments, const std::vector<std::string>& more = {}) const {
    return run(folder_, arguments, Stdout::kFile, environment(more));
  }

  ScratchFolder folder_, temporary_;
};

class SandboxedOutput : public Sandboxed, public testing::WithParamInterface<const char*> {};

TEST_P(SandboxedOutput, HasTheSameBytesAsWithoutTheSandbox) {
  const Output output{GetParam(), 0.6};
  const RunResult made = runIn(untrusted(renderArguments(output, {"-j", "2"})));
  ASSERT_EQ(made.exitCode, 0) << made.err;
  EXPECT_EQ(filesOf(folder_.path()), undisturbed(output));
  EXPECT_THAT(namesIn(temporary_.path()), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Each, SandboxedOutput,
                         testing::Values("t.mp4", "t.mov", "t.webm", "t.gif", "t.apng", "t_{frame:03}.png"),
                         [](const auto& each) { return std::to_string(each.index); });

TEST_F(Sandboxed, MakesTheSameStillsAndFigures) {
  for (const std::string name : {"a.png", "a.pdf", "a.svg", "a.tex"}) {
    const std::vector<std::string> still{"still", "tiny.toml", "-o", name, "--quiet", "--force"};
    ASSERT_EQ(runIn(still).exitCode, 0);
    const std::string bytes = bytesOf(folder_ / name);
    const RunResult made = runIn(untrusted(still));
    ASSERT_EQ(made.exitCode, 0) << made.err;
    EXPECT_EQ(bytesOf(folder_ / name), bytes) << name;
  }
}

TEST_F(Sandboxed, MakesTheFolderOfASequence) {
  const RunResult made = runIn(untrusted(renderArguments({"frames/t_{frame:03}.png", 0.6})));
  ASSERT_EQ(made.exitCode, 0) << made.err;
  EXPECT_EQ(filesOf(folder_ / "frames"), undisturbed(kShortSequence));
}

TEST_F(Sandboxed, DryRunMakesNoFolder) {
  for (const std::vector<std::string>& where : {std::vector<std::string>{}, {"-o", "new/{frame:03}.png"}}) {
    std::vector<std::string> words{"render", "tiny.toml", "--dry-run"};
    words.insert(words.end(), where.begin(), where.end());
    const auto result = runIn(untrusted(words));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(namesIn(folder_.path()), std::vector<std::string>{"tiny.toml"});
  }
}

TEST_F(Sandboxed, WritesAFilmToStandardOutput) {
  const RunResult plain = runIn(renderArguments({"-", 0.6}, {"--format", "mp4"}));
  const RunResult made = runIn(untrusted(renderArguments({"-", 0.6}, {"--format", "mp4"})));
  ASSERT_EQ(made.exitCode, 0) << made.err;
  EXPECT_EQ(made.out, plain.out);
  EXPECT_THAT(namesIn(temporary_.path()), IsEmpty());
}

/// Returns lines such as "worker socket: Operation not permitted".
std::set<std::string> probesIn(const std::string& err) {
  std::set<std::string> lines;
  const std::regex line("probe ([^\n]*)\n");
  for (std::sregex_iterator at(err.begin(), err.end(), line), end; at != end; ++at) lines.insert((*at)[1]);
  return lines;
}

// The control run shows that an unconfined probe succeeds in its actions.
TEST_F(Sandboxed, CannotAccessFilesNetworkOrProcesses) {
  const ScratchFolder elsewhere;
  const std::vector<std::string> probe{"LD_PRELOAD=" POINSOT_SANDBOX_PROBE,
                                       "PROBE_OUTSIDE=" + elsewhere.put("secret", "secret").string()};
  const RunResult made = runIn(untrusted(renderArguments(kShortFilm)), probe);
  EXPECT_EQ(made.exitCode, 0) << made.err;
  const auto probes = probesIn(made.err);
  EXPECT_EQ(probes.size(), 2 * 16 + 1u) << made.err;
  for (const std::string& line : probes) EXPECT_THAT(line, Not(HasSubstr(": done")));
  for (const std::string who : {"worker", "parent"})
    for (const std::string what :
         {"passwd: Permission denied", "outside: Permission denied", "socket: Operation not permitted",
          "execute: Operation not permitted", "ptrace: Operation not permitted", "mount: Operation not permitted"})
      EXPECT_THAT(probes, Contains(who + " " + what));
  EXPECT_THAT(probes, Contains("worker fork: Operation not permitted"));
  EXPECT_EQ(bytesOf(elsewhere / "secret"), "secret");
  EXPECT_EQ(filesOf(folder_.path()), undisturbed(kShortFilm));
}

TEST_F(Sandboxed, ProbeSucceedsWithoutTheSandbox) {
  const ScratchFolder elsewhere;
  const std::vector<std::string> probe{"LD_PRELOAD=" POINSOT_SANDBOX_PROBE,
                                       "PROBE_OUTSIDE=" + elsewhere.put("secret", "secret").string()};
  const RunResult made = runIn(renderArguments(kShortFilm), probe);
  for (const std::string what : {"passwd", "outside", "create", "remove", "socket", "link", "pipe"})
    EXPECT_THAT(made.err, HasSubstr(" " + what + ": done"));
}

TEST_F(Sandboxed, RefusesToStartWithoutLandlock) {
  const RunResult made =
      runIn(untrusted(renderArguments(kShortFilm)), {"LD_PRELOAD=" POINSOT_SANDBOX_PROBE, "PROBE_NO_LANDLOCK=1"});
  EXPECT_EQ(made.exitCode, 3);
  EXPECT_THAT(made.err, HasSubstr("--untrusted: this kernel cannot restrict a process to its files (Function not "
                                  "implemented); Linux 5.19 or later with Landlock enabled is needed"));
  EXPECT_THAT(filesOf(folder_.path()), IsEmpty());
}

TEST_F(Sandboxed, ReportsSceneErrorsAsUsual) {
  folder_.put("bad.toml", "[body]\nshape = 'no-such'\n");
  const RunResult plain = runIn({"check", "bad.toml"}), made = runIn({"check", "bad.toml", "--untrusted"});
  EXPECT_EQ(made.exitCode, 2);
  EXPECT_EQ(made.err, plain.err);
}

pid_t childOf(pid_t program) {
  for (int i = 0; i < 500; ++i) {
    std::ifstream children("/proc/" + std::to_string(program) + "/task/" + std::to_string(program) + "/children");
    if (pid_t child = 0; children >> child) return child;
    usleep(10'000);
  }
  return -1;
}

TEST_F(Sandboxed, SetsTheResourceLimitsOfTheOptions) {
  ProgramRun running(folder_,
                     untrusted(renderArguments(
                         kLongFilm, {"--max-memory", "1GiB", "--max-seconds", "100", "--limit", "output=1MiB"})),
                     Stdout::kFile, environment());
  const pid_t confined = childOf(running.pid());
  ASSERT_GT(confined, 0);
  const pid_t worker = childOf(confined);  // a worker exists only after its parent has entered the sandbox
  ASSERT_GT(worker, 0);
  for (const pid_t process : {confined, worker}) {
    std::ostringstream limits;
    limits << std::ifstream("/proc/" + std::to_string(process) + "/limits").rdbuf();
    for (const char* line :
         {"Max address space +4294967296 +4294967296 ", "Max cpu time +100 +105 ",
          "Max file size +1048576 +1048576 ", "Max core file size +0 +0 ", "Max open files +1024 +1024 "})
      EXPECT_THAT(limits.str(), testing::ContainsRegex(line));
  }
}

// libseccomp 2.5 crashes if memory runs out while it builds its filter. The exact moment depends on the heap's
// content.
TEST_F(Sandboxed, ReportsMissingMemoryAtAnyLimit) {
  std::filesystem::copy_file(POINSOT_SOURCE_DIR "/scenes/football.toml", folder_ / "football.toml");
  std::filesystem::create_directory(folder_ / "home");
  for (const char* scene : {"tiny.toml", "football.toml"})
    for (const char* memory : {"1MiB", "2MiB", "5MiB", "12MiB"})
      for (const std::size_t padding : {0, 3000, 30'000}) {
        const RunResult ended =
            runIn(untrusted({"render", scene, "-o", "t.mp4", "--max-memory", memory}),
                  {"HOME=" + (folder_ / "home").string(), "LANG=" + std::string(padding, 'x')});
        EXPECT_THAT(ended.exitCode, testing::AnyOf(2, 3)) << scene << ' ' << memory;
        EXPECT_THAT(ended.err, testing::AnyOf(HasSubstr("memory"), HasSubstr("cannot be opened"))) << memory;
      }
}

TEST_F(Sandboxed, EndsCleanlyOnASignal) {
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    ProgramRun running(folder_, untrusted(renderArguments(kLongFilm)), Stdout::kFile, environment());
    ASSERT_GT(childOf(running.pid()), 0);
    usleep(400'000);
    running.signal(signal);
    EXPECT_EQ(running.wait().exitCode, 128 + signal);
    EXPECT_THAT(namesIn(temporary_.path()), IsEmpty());
  }
}

TEST_F(Sandboxed, ExitsWithTheSignalThatKilledIt) {
  ProgramRun running(folder_, untrusted(renderArguments(kLongFilm)), Stdout::kFile, environment());
  const pid_t confined = childOf(running.pid());
  ASSERT_GT(confined, 0);
  kill(confined, SIGKILL);
  EXPECT_EQ(running.wait().exitCode, 128 + SIGKILL);
  EXPECT_THAT(namesIn(temporary_.path()), IsEmpty());
}

TEST_F(Sandboxed, RunsTheOtherCommands) {
  ASSERT_EQ(runIn({"still", "tiny.toml", "-o", "a.png", "--quiet"}).exitCode, 0);
  const std::vector<std::vector<std::string>> commands{
      {"check", "tiny.toml"},
      {"info", "tiny.toml"},
      {"trajectory", "tiny.toml", "--rate", "10", "-o", "a.csv"},
      {"grade", "tiny.toml", "a.csv"},
      {"diff", "a.png", "a.png", "--report", "a.html"},
      {"submit", "tiny.toml", "-o", "a.mp4", "--engine", "make"},
      {"gallery", "tiny.toml", "-o", "gallery", "--size", "64x36", "--quiet"}};
  for (const auto& command : commands) {
    const RunResult made = runIn(untrusted(command));
    EXPECT_EQ(made.exitCode, 0) << command[0] << ": " << made.err << made.out;
  }
}

TEST_F(Sandboxed, ReadsFilesOfAnAssetRoot) {
  const ScratchFolder elsewhere;
  elsewhere.put("torque.csv", "0,0,0,0\n2,0,0,1\n");
  folder_.put("driven.toml", std::string(kTinyScene) + "[motion.torque]\nfile = 'torque.csv'\n");
  const RunResult found = runIn(untrusted({"check", "driven.toml", "--asset-root", elsewhere.path().string()}));
  EXPECT_EQ(found.exitCode, 0) << found.err;
  EXPECT_EQ(runIn(untrusted({"check", "driven.toml"})).exitCode, 2);
}

TEST_F(Sandboxed, ComparesGoldenPictures) {
  folder_.put("golden.toml", "[[test]]\nname = 'tiny'\nscene = 'tiny.toml'\nsize = [64, 36]\n");
  const RunResult approved = runIn({"golden", "--update", "--quiet"}, {"CI="});
  ASSERT_EQ(approved.exitCode, 0) << approved.err;
  const RunResult made = runIn({"golden", "--untrusted", "--report", "g.html", "--junit", "g.xml"});
  EXPECT_EQ(made.exitCode, 0) << made.out << made.err;
  EXPECT_THAT(made.out, HasSubstr("1 identical"));
  const RunResult refused = runIn({"golden", "--untrusted", "--update"}, {"CI="});
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_THAT(refused.err,
              HasSubstr("--update: not possible with --untrusted, because untrusted pictures are never approved"));
}

}  // namespace
}  // namespace poinsot::faults
