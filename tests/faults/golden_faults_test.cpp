// SPDX-License-Identifier: Apache-2.0
// References change together. At every possible place, a call fails or the process is killed there. After exit
// code 0, all references equal those of an undisturbed run; after any other code, all are as before.
#include <gmock/gmock.h>
#include <signal.h>

#include <cerrno>
#include <map>

#include "cli/golden_images_fixture.h"
#include "faults/tiny_film.h"

namespace poinsot::faults {
namespace {

namespace fs = std::filesystem;
using testing::Combine;
using testing::Values;

constexpr int kKilled = 1000 + SIGKILL;

std::string errnoText(int why) { return std::to_string(why); }

using Files = std::map<std::string, std::string>;

Files filesBelow(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[entry.path().lexically_relative(folder)] = bytesOf(entry.path());
  return files;
}

/// Returns a grey picture or animation. Two of them with unequal widths differ without a map, which keeps the runs
/// short.
Bytes still(std::uint32_t width) { return pngBytes({width, 8, 8, 0, {}}, Bytes(width * std::size_t{8}, 90)); }
Bytes film(std::uint32_t width) {
  const Bytes frame(width * std::size_t{8}, 90);
  return apngBytes({width, 8, 8, 0, {}}, {frame, frame}, {100, 100});
}

struct Change {
  const char* name;
  std::vector<std::string> words;
  std::string folder;
};

const Change kSuite{"Golden", {"golden", "--update", "--variant", "two"}, "ref"};
const Change kPairs{"Diff", {"diff", "old", "new", "--update", "*"}, "old"};

RunResult apply(const Change& change, const ScratchFolder& folder, std::vector<std::string> environment = {}) {
  environment.emplace_back("CI=");
  return run(folder, change.words, Stdout::kFile, environment);
}

/// Makes a suite in which an update replaces a picture and a film, removes a reference of another renderer, and
/// adds the first reference of a test in a subfolder. Beside the suite are two folders with similar files.
void makeSuite(const ScratchFolder& folder) {
  const auto save = [&](const std::string& place, std::uint32_t width) {
    saveBytes(folder / (place + "/a.png"), still(width));
    saveBytes(folder / (place + "/c.apng"), film(width));
  };
  const auto approve = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"golden", "--update"};
    words.insert(words.end(), more.begin(), more.end());
    ASSERT_EQ(run(folder, words, Stdout::kFile, {"CI="}).exitCode, 0);
  };
  const std::string suite = "references = 'ref'\n[[test]]\nimage = 'new/a.png'\n[[test]]\nimage = 'new/c.apng'\n";
  folder.put("golden.toml", suite);
  save("old", 16);
  save("new", 16);
  approve({"--variant", "one"});
  save("new", 24);
  approve({"--beside", "--variant", "x", "--only", "a"});
  save("new", 20);
  saveBytes(folder / "new/n.png", still(20));
  folder.put("golden.toml", suite + "[[test]]\nname = 'deep/n'\nimage = 'new/n.png'\n");
}

/// References before and after an undisturbed run; made once for each command.
struct Undisturbed {
  Files all, before, after;  ///< `all`: the whole folder before the run
};

const Undisturbed& undisturbed(const Change& change) {
  static std::map<std::string, Undisturbed> made;
  const auto [place, isNew] = made.try_emplace(change.name);
  if (isNew) {
    const ScratchFolder folder;
    makeSuite(folder);
    place->second.all = filesBelow(folder.path());
    place->second.before = filesBelow(folder / change.folder);
    const RunResult result = apply(change, folder);
    EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
    place->second.after = filesBelow(folder / change.folder);
    for (const auto& [name, bytes] : place->second.after)
      EXPECT_FALSE(place->second.before.contains(name) && place->second.before[name] == bytes) << name;
  }
  return place->second;
}

void put(const ScratchFolder& folder, const Files& files) {
  for (const auto& [name, bytes] : files) saveBytes(folder / name, {bytes.begin(), bytes.end()});
}

class ChangesTogether : public testing::TestWithParam<std::tuple<Change, Fault>> {
 protected:
  /// Runs the command with the fault at the n-th call and passes the result to `expect`, for every n until there
  /// is no such call.
  template <class Expect>
  void atEachCall(Expect expect) const {
    const auto& [change, fault] = GetParam();
    for (int n = 1;; ++n) {
      SCOPED_TRACE("call " + std::to_string(n));
      const ScratchFolder folder;
      put(folder, undisturbed(change).all);
      const RunResult result = apply(change, folder, environmentOf(fault, n, folder));
      if (!struck(folder)) {
        EXPECT_EQ(result.exitCode, 0) << result.err;
        EXPECT_EQ(filesBelow(folder / change.folder), undisturbed(change).after);
        EXPECT_GT(n, 1) << "there is no such call";
        return;
      }
      expect(change, folder, result);
    }
  }
};

using GoldenFault = ChangesTogether;

TEST_P(GoldenFault, ChangesAllReferencesOrNone) {
  atEachCall([](const Change& change, const ScratchFolder& folder, const RunResult& result) {
    const Undisturbed& known = undisturbed(change);
    EXPECT_THAT(result.exitCode, testing::AnyOf(0, 4)) << result.err;
    EXPECT_EQ(filesBelow(folder / change.folder), result.exitCode == 0 ? known.after : known.before);
  });
}

// A drawing must be written before it can be approved, and the file must contain that drawing.
class DrawingFault : public testing::TestWithParam<Fault> {};

TEST_P(DrawingFault, PreventsAnyApproval) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  saveBytes(folder / "new.png", still(16));
  folder.put("golden.toml", "size = [64, 36]\n[[test]]\nimage = 'new.png'\n[[test]]\nscene = 'tiny.toml'\n");
  const Change all{"Scene", {"golden", "--update"}, "golden"};
  ASSERT_EQ(apply(all, folder).exitCode, 0);
  saveBytes(folder / "new.png", still(20));
  folder.put(".harness-other.png", bytesOf(folder / "golden/tiny.png"));  // of the earlier scene
  folder.put("tiny.toml", std::string(kTinyScene) + "[style]\ntheme = 'dark'\n");
  const Files before = filesBelow(folder / "golden");
  const RunResult result = apply(all, folder, environmentOf(GetParam(), 1, folder));
  ASSERT_TRUE(struck(folder));
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.out, testing::MatchesRegex("error      tiny: [^\n]*\n.*nothing was approved: [^\n]*\n"));
  EXPECT_TRUE(filesBelow(folder / "golden") == before);
  EXPECT_EQ(apply(all, folder).exitCode, 0);
  EXPECT_FALSE(filesBelow(folder / "golden") == before);
}

std::string kindOfFault(const testing::TestParamInfo<Fault>& info) {
  return info.param.call + (info.param.kind == "swap" ? "_swap" : "_fails");
}

INSTANTIATE_TEST_SUITE_P(Each, DrawingFault,
                         Values(Fault{"write", "worker", errnoText(ENOSPC), true},
                                Fault{"rename", "worker", errnoText(EIO)}, Fault{"rename", "worker", "swap"}),
                         kindOfFault);

std::string faultOf(const testing::TestParamInfo<std::tuple<Change, Fault>>& info) {
  return std::get<0>(info.param).name + std::string("_") + std::get<1>(info.param).call;
}

INSTANTIATE_TEST_SUITE_P(
    Suite, GoldenFault,
    Combine(Values(kSuite),
            Values(Fault{"open", "parent", errnoText(EDQUOT)}, Fault{"write", "parent", errnoText(ENOSPC), true},
                   Fault{"fsync", "parent", errnoText(EIO)}, Fault{"close", "parent", errnoText(EIO)},
                   Fault{"rename", "parent", errnoText(EACCES)}, Fault{"mkdir", "parent", errnoText(EROFS)})),
    faultOf);
INSTANTIATE_TEST_SUITE_P(Pairs, GoldenFault,
                         Combine(Values(kPairs), Values(Fault{"write", "parent", errnoText(ENOSPC), true},
                                                        Fault{"fsync", "parent", errnoText(EIO)},
                                                        Fault{"rename", "parent", errnoText(EACCES)})),
                         faultOf);

using GoldenWithoutLinks = ChangesTogether;

// File systems without second names of a file, such as FAT: the old file is moved instead.
TEST_P(GoldenWithoutLinks, ChangesAllReferences) {
  atEachCall([](const Change& change, const ScratchFolder& folder, const RunResult& result) {
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(filesBelow(folder / change.folder), undisturbed(change).after);
  });
}

INSTANTIATE_TEST_SUITE_P(Each, GoldenWithoutLinks,
                         Combine(Values(kSuite), Values(Fault{"link", "parent", errnoText(EPERM), true})),
                         faultOf);

using KilledApproval = ChangesTogether;

/// Checks that a picture and its description, if any, belong to one approval.
void expectOwnOrigin(const Files& now, const std::string& picture, const Undisturbed& known) {
  const std::string json = picture.substr(0, picture.rfind('.')) + ".json";
  const auto isOf = [&](const Files& files, const std::string& name) {
    return files.contains(name) && files.at(name) == now.at(name);
  };
  const bool isOld = isOf(known.before, picture), isNew = isOf(known.after, picture);
  EXPECT_TRUE(isOld || isNew) << picture;
  EXPECT_TRUE(!now.contains(json) || isOf(isOld ? known.before : known.after, json)) << json;
}

TEST_P(KilledApproval, LeavesNoReferenceWithTheDescriptionOfAnother) {
  atEachCall([](const Change& change, const ScratchFolder& folder, const RunResult& killed) {
    const Undisturbed& known = undisturbed(change);
    ASSERT_EQ(killed.exitCode, kKilled);
    const Files now = filesBelow(folder / change.folder);
    for (const auto& [name, bytes] : now)
      if (!name.ends_with(".json") && fs::path(name).filename().native().front() != '.')
        expectOwnOrigin(now, name, known);
    const RunResult again = apply(change, folder);
    // A description without its picture is reported. It belongs to the reference that was to be removed.
    EXPECT_EQ(again.exitCode, now.contains("a@x.json") && !now.contains("a@x.png") ? 1 : 0) << again.out;
    for (const auto& [name, bytes] : known.after) EXPECT_EQ(bytesOf(folder / change.folder / name), bytes) << name;
  });
}

INSTANTIATE_TEST_SUITE_P(Each, KilledApproval,
                         Combine(Values(kSuite),
                                 Values(Fault{"link", "parent", "kill"}, Fault{"rename", "parent", "kill"})),
                         faultOf);

}  // namespace
}  // namespace poinsot::faults
