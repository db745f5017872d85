// SPDX-License-Identifier: Apache-2.0
// Outputs of several files. If any call fails, exit code 4 leaves the earlier files, byte for byte. If a run is
// killed at any point, no file stands beside a companion of another run. CI tries some calls of each command, the
// nightly run tries all.
#include <gmock/gmock.h>

#include <cerrno>
#include <cstdlib>
#include <map>

#include "faults/tiny_film.h"

namespace poinsot::faults {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;
using Files = std::map<std::string, std::string>;

struct Command {
  std::string name;
  std::vector<Words> before;  ///< commands that make the earlier outputs from old.toml
  Words words;
  /// Groups of files; the files of a group depend on its first file. An independent file is a group of its own.
  std::vector<Words> groups;
  int exitCode = 0;  ///< exit code of a successful run
};

void PrintTo(const Command& command, std::ostream* out) { *out << command.name; }

const Words kFilmGroup{"o.mp4", "o.srt", "o.vtt", "m.json", "t.json"};
const Words kReports{"--map", "map.png", "--diff-image", "d.png", "--report", "r.html", "--junit", "j.xml"};

Words joined(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Words still(const char* scene, const char* picture) {
  return {"still", scene, "-o", picture, "--trace", "t.json", "--quiet", "--width", "20mm", "--dpi", "80"};
}

Words film(const char* scene) { return {"render", scene, "-o", "o.mp4", "--segment", "1", "-j", "1", "--quiet"}; }

const Words kBesides{"--manifest", "m.json", "--trace", "t.json"};

const std::vector<Command> kCommands{
    {"Film", {joined(film("old.toml"), kBesides)}, joined(film("s.toml"), kBesides), {kFilmGroup}},
    // The captions of an earlier film are removed with it.
    {"FilmWithoutCaptions", {film("old.toml")}, film("mute.toml"), {{"o.mp4", "o.srt", "o.vtt"}}},
    {"Assemble",
     {film("old.toml"), joined(film("s.toml"), {"--shard", "1/1"})},
     {"assemble", "o.mp4", "--quiet"},
     {{"o.mp4", "o.srt", "o.vtt"}}},
    {"StillTex",
     {still("old.toml", "o.tex")},
     still("s.toml", "o.tex"),
     {{"o-unlabelled.png", "o.tex", "t.json"}}},
    {"StillPdf", {still("old.toml", "o.pdf")}, still("s.toml", "o.pdf"), {{"o.pdf", "t.json"}}},
    {"StillSvg", {still("old.toml", "o.svg")}, still("s.toml", "o.svg"), {{"o.svg", "t.json"}}},
    {"StillPng", {still("old.toml", "o.png")}, still("s.toml", "o.png"), {{"o.png", "t.json"}}},
    {"Sweep",
     {{"sweep", "old.toml", "-D", "time.start=0|1", "-o", "o.tex", "--quiet", "--width", "20mm", "--dpi", "80"}},
     {"sweep", "s.toml", "-D", "time.start=0|1", "-o", "o.tex", "--quiet", "--width", "20mm", "--dpi", "80"},
     {{"o-unlabelled.png", "o.tex"}}},
    {"Diff",
     {{"still", "s.toml", "-o", "a.png", "--quiet"},
      {"still", "old.toml", "-o", "b.png", "--quiet"},
      {"still", "s.toml", "-o", "c.png", "--quiet", "-D", "show.L=true"},
      joined({"diff", "a.png", "c.png", "--quiet"}, kReports)},
     joined({"diff", "a.png", "b.png", "--quiet", "--markdown", "s.md"}, kReports),
     {{"map.png"}, {"d.png"}, {"r.html"}, {"j.xml"}, {"s.md"}},
     1},
    {"Trajectory",
     {{"trajectory", "old.toml", "--at", "0", "-o", "o.csv"}},
     {"trajectory", "s.toml", "--at", "0", "-o", "o.csv"},
     {{"o.csv"}}},
    {"New", {{"new", "n"}}, {"new", "n", "--from", "s", "--force"}, {{"n.toml"}}},
};

bool takesAll() { return std::getenv("POINSOT_EVERY_CALL") != nullptr; }

class OutputOfSeveralFiles : public testing::TestWithParam<Command> {
 protected:
  void SetUp() override {
    const std::string head = std::string(kTinyScene) + "[output]\nsize = [64, 36]\n";
    const std::string caption = "[[timeline]]\nat = 0\ncaption = ";
    before_.put("s.toml", head + caption + "'new'\n");
    before_.put("mute.toml", head);
    before_.put("old.toml", head + caption + "'old'\n");
    fs::create_directory(before_ / "scenes");
    fs::copy(before_ / "s.toml", before_ / "scenes/s.toml");
    before_.put("s.md", "mine\n");
    for (Words words : GetParam().before) {
      if (words[1] == "old.toml") words.insert(words.end(), {"-D", "motion.omega_body=[1,2,3]"});
      const int exitCode = runIn(before_, short_(words), {}).exitCode;
      ASSERT_EQ(exitCode, words[0] == "diff" ? 1 : 0) << words[0];
    }
    old_ = files(before_);
  }

  /// Shortens a film to two frames.
  static Words short_(Words words) {
    if (words[0] == "render") words.insert(words.end(), {"-D", "time.duration=0.2"});
    return words;
  }

  static RunResult runIn(const ScratchFolder& folder, const Words& words, const Words& environment) {
    Words all{"POINSOT_SCENES=" + (folder / "scenes").string()};
    all.insert(all.end(), environment.begin(), environment.end());
    return run(folder, words, Stdout::kFile, all);
  }

  RunResult runAgain(const ScratchFolder& folder, const Words& environment = {}) const {
    return runIn(folder, short_(GetParam().words), environment);
  }

  static Files files(const ScratchFolder& folder) {
    Files all;
    for (const std::string& name : namesIn(folder.path()))
      if (!name.starts_with('.') && fs::is_regular_file(folder / name)) all[name] = bytesOf(folder / name);
    return all;
  }

  static Words temporaryFiles(const ScratchFolder& folder) {
    Words names;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
      if (entry.path().extension() == ".tmp") names.push_back(entry.path().filename());
    return names;
  }

  std::unique_ptr<ScratchFolder> copyOfBefore() const {
    auto folder = std::make_unique<ScratchFolder>();
    fs::copy(before_.path(), folder->path(), fs::copy_options::recursive);
    return folder;
  }

  /// Runs the command with the fault at the n-th call of a kind, and calls `check`. The nightly run tries every n,
  /// CI only some. @returns the number of calls tried
  template <class Check>
  int forEachCall(const Fault& fault, int first, int step, const Check& check) const {
    int tried = 0;
    for (int n = takesAll() ? 1 : first;; n += takesAll() ? 1 : step, ++tried) {
      const auto folder = copyOfBefore();
      const RunResult told = runAgain(*folder, environmentOf(fault, n, *folder));
      if (!struck(*folder)) return tried;
      check(*folder, told, fault.call + " " + std::to_string(n) + " of the " + fault.role + ": " + told.err);
    }
  }

  bool isNew(const Files& now, const std::string& name) const {
    const auto before = old_.find(name);
    const auto found = now.find(name);
    return found != now.end() && (before == old_.end() || found->second != before->second);
  }

  void expectAllNew(const ScratchFolder& folder, const std::string& where) const {
    const Files now = files(folder);
    for (const Words& group : GetParam().groups)
      for (const std::string& name : group) {
        const bool hasNone = GetParam().name == "FilmWithoutCaptions" && name != "o.mp4";
        EXPECT_EQ(now.contains(name), !hasNone) << name << where;
        EXPECT_TRUE(hasNone || isNew(now, name)) << name << where;
      }
  }

  ScratchFolder before_;
  Files old_;
};

TEST_P(OutputOfSeveralFiles, IsReplacedCompletelyOrNotAtAll) {
  int tried = 0, refused = 0;
  const auto check = [&](const ScratchFolder& folder, const RunResult& told, const std::string& where) {
    if (told.exitCode == GetParam().exitCode) return expectAllNew(folder, where);  // the call was optional
    EXPECT_EQ(told.exitCode, 4) << where;
    EXPECT_TRUE(files(folder) == old_) << where;
    EXPECT_THAT(temporaryFiles(folder), testing::IsEmpty()) << where;
    ++refused;
  };
  const auto fail = [&](const char* call, const char* role, int why, int first, int step, bool onwards = false) {
    tried += forEachCall({call, role, std::to_string(why), onwards}, first, step, check);
  };
  fail("rename", "parent", EXDEV, 1, 3);
  fail("write", "parent", ENOSPC, 1, 9);
  fail("fsync", "parent", EIO, 2, 9);
  if (takesAll()) {
    fail("open", "parent", ENOSPC, 1, 1);
    fail("close", "parent", EIO, 1, 1);
    fail("write", "parent", ENOSPC, 1, 1, true);
    fail("link", "parent", EPERM, 1, 1);
    fail("mkdir", "parent", EROFS, 1, 1);
    for (const char* call : {"open", "write", "fsync", "close", "rename"}) fail(call, "worker", EIO, 1, 1);
  }
  EXPECT_GT(refused, 0);
  std::printf("%-20s %3d places, %3d of them exit 4\n", GetParam().name.c_str(), tried, refused);
}

class KilledOutput : public OutputOfSeveralFiles {};

/// Returns the commands with several dependent files; at night all commands.
std::vector<Command> commandsToKill() {
  std::vector<Command> commands;
  for (const Command& command : kCommands)
    if (takesAll() || command.groups.front().size() > 1) commands.push_back(command);
  return commands;
}

// After the kill, the command runs again and completes its outputs.
TEST_P(KilledOutput, NeverMixesFilesOfTwoRuns) {
  int tried = 0;
  const auto check = [&](const ScratchFolder& folder, const RunResult& told, const std::string& where) {
    EXPECT_EQ(told.exitCode, 1000 + SIGKILL) << where;
    const Files now = files(folder);
    for (const Words& group : GetParam().groups) {
      const std::string& main = group.front();
      EXPECT_TRUE(now.contains(main) || !old_.contains(main)) << main << where;
      for (const std::string& name : group) {
        const bool isThere = now.contains(name);
        EXPECT_TRUE(!isThere || isNew(now, name) == isNew(now, main)) << name << " beside " << main << where;
      }
    }
    const RunResult again = runAgain(folder);
    if (GetParam().name == "Assemble" && again.exitCode == 4) return;  // the segments were already removed
    EXPECT_EQ(again.exitCode, GetParam().exitCode) << where << again.err;
    expectAllNew(folder, where);
  };
  tried += forEachCall({"rename", "parent", "kill"}, 2, 3, check);
  // On file systems without second names, such as FAT, the old file and the new file change names.
  tried += forEachCall({"rename", "parent", "kill", false, "link"}, 2, 3, check);
  if (takesAll())
    for (const char* call : {"open", "write", "fsync", "close", "link"})
      tried += forEachCall({call, "parent", "kill"}, 1, 1, check);
  std::printf("%-20s %3d kills\n", GetParam().name.c_str(), tried);
}

// Without links and exchange, the new file is renamed over the old file.
TEST(OutputOfOneFile, NeverDisappearsOnFileSystemsWithoutLinks) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  const auto words = [](const char* time) {
    return Words{"trajectory", "tiny.toml", "--at", time, "-o", "o.csv"};
  };
  ASSERT_EQ(run(folder, words("0")).exitCode, 0);
  const std::string old = bytesOf(folder / "o.csv");
  int n = 1;
  for (;; ++n) {
    run(folder, words("1"), Stdout::kFile,
        environmentOf({"rename", "parent", "kill", false, "link exchange"}, n, folder));
    ASSERT_TRUE(fs::exists(folder / "o.csv")) << n;
    if (!struck(folder)) break;
    EXPECT_EQ(bytesOf(folder / "o.csv"), old) << n;
  }
  EXPECT_GT(n, 1);
  EXPECT_NE(bytesOf(folder / "o.csv"), old);
}

const auto nameOf = [](const auto& one) { return one.param.name; };
INSTANTIATE_TEST_SUITE_P(Each, OutputOfSeveralFiles, testing::ValuesIn(kCommands), nameOf);
INSTANTIATE_TEST_SUITE_P(Each, KilledOutput, testing::ValuesIn(commandsToKill()), nameOf);

}  // namespace
}  // namespace poinsot::faults
