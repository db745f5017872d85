// SPDX-License-Identifier: Apache-2.0
// References change together. A call fails, or the process is killed at it, at every place there is; then exit 0
// means that all references are what an undisturbed run makes of them, and any other code that all are what they
// were.
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

/// Files below a folder, and their bytes.
using Files = std::map<std::string, std::string>;

Files filesBelow(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[entry.path().lexically_relative(folder)] = bytesOf(entry.path());
  return files;
}

/// A grey picture or animation. Those of two widths are different without a map, which keeps the runs short.
Bytes still(std::uint32_t width) { return pngBytes({width, 8, 8, 0, {}}, Bytes(width * std::size_t{8}, 90)); }
Bytes film(std::uint32_t width) {
  const Bytes frame(width * std::size_t{8}, 90);
  return apngBytes({width, 8, 8, 0, {}}, {frame, frame}, {100, 100});
}

/// A command that changes the files of a folder together.
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

/// A suite in which a picture and a film are to be replaced, a reference of another renderer is to be removed, and
/// one in a folder of its own is the first of its test. Beside it two folders with the like.
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

/// The references before and after an undisturbed run; made once for each command.
struct Undisturbed {
  Files all, before, after;  ///< `all`: before, of the whole folder
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
  /// Calls `expect` with what became of it for the n-th call, for every n there is.
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

TEST_P(GoldenFault, LeavesAllOrNone) {
  atEachCall([](const Change& change, const ScratchFolder& folder, const RunResult& result) {
    const Undisturbed& known = undisturbed(change);
    EXPECT_THAT(result.exitCode, testing::AnyOf(0, 4)) << result.err;
    EXPECT_EQ(filesBelow(folder / change.folder), result.exitCode == 0 ? known.after : known.before);
  });
}

// A drawing has to be written before it can be approved, and the file there has to be that drawing.
class FaultOfADrawing : public testing::TestWithParam<Fault> {};

TEST_P(FaultOfADrawing, ApprovesNothing) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  saveBytes(folder / "new.png", still(16));
  folder.put("golden.toml", "size = [64, 36]\n[[test]]\nimage = 'new.png'\n[[test]]\nscene = 'tiny.toml'\n");
  const Change all{"Scene", {"golden", "--update"}, "golden"};
  ASSERT_EQ(apply(all, folder).exitCode, 0);
  saveBytes(folder / "new.png", still(20));
  folder.put(".harness-other.png", bytesOf(folder / "golden/tiny.png"));  // of the scene before: would pass
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

INSTANTIATE_TEST_SUITE_P(Of, FaultOfADrawing,
                         Values(Fault{"write", "worker", errnoText(ENOSPC), true},
                                Fault{"rename", "worker", errnoText(EIO)}, Fault{"rename", "worker", "swap"}),
                         kindOfFault);

std::string faultOf(const testing::TestParamInfo<std::tuple<Change, Fault>>& info) {
  return std::get<0>(info.param).name + std::string("_") + std::get<1>(info.param).call;
}

INSTANTIATE_TEST_SUITE_P(
    Of, GoldenFault,
    Combine(Values(kSuite),
            Values(Fault{"open", "parent", errnoText(EDQUOT)}, Fault{"write", "parent", errnoText(ENOSPC), true},
                   Fault{"fsync", "parent", errnoText(EIO)}, Fault{"close", "parent", errnoText(EIO)},
                   Fault{"rename", "parent", errnoText(EACCES)}, Fault{"mkdir", "parent", errnoText(EROFS)})),
    faultOf);
INSTANTIATE_TEST_SUITE_P(OfPairs, GoldenFault,
                         Combine(Values(kPairs), Values(Fault{"write", "parent", errnoText(ENOSPC), true},
                                                        Fault{"fsync", "parent", errnoText(EIO)},
                                                        Fault{"rename", "parent", errnoText(EACCES)})),
                         faultOf);

using GoldenWithoutLinks = ChangesTogether;

// File systems that know no second names of a file, such as FAT: the old file is moved instead.
TEST_P(GoldenWithoutLinks, ChangesAll) {
  atEachCall([](const Change& change, const ScratchFolder& folder, const RunResult& result) {
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(filesBelow(folder / change.folder), undisturbed(change).after);
  });
}

INSTANTIATE_TEST_SUITE_P(Of, GoldenWithoutLinks,
                         Combine(Values(kSuite), Values(Fault{"link", "parent", errnoText(EPERM), true})),
                         faultOf);

using KilledApproval = ChangesTogether;

/// Checks that a picture and its description, if it has one, are of one approval.
void expectOwnOrigin(const Files& now, const std::string& picture, const Undisturbed& known) {
  const std::string json = picture.substr(0, picture.rfind('.')) + ".json";
  const auto isOf = [&](const Files& files, const std::string& name) {
    return files.contains(name) && files.at(name) == now.at(name);
  };
  const bool isOld = isOf(known.before, picture), isNew = isOf(known.after, picture);
  EXPECT_TRUE(isOld || isNew) << picture;
  EXPECT_TRUE(!now.contains(json) || isOf(isOld ? known.before : known.after, json)) << json;
}

TEST_P(KilledApproval, LeavesNoPictureWithTheOriginOfAnother) {
  atEachCall([](const Change& change, const ScratchFolder& folder, const RunResult& killed) {
    const Undisturbed& known = undisturbed(change);
    ASSERT_EQ(killed.exitCode, kKilled);
    const Files now = filesBelow(folder / change.folder);
    for (const auto& [name, bytes] : now)
      if (!name.ends_with(".json") && fs::path(name).filename().native().front() != '.')
        expectOwnOrigin(now, name, known);
    const RunResult again = apply(change, folder);
    // A description that lost its picture is reported: it is of the reference that was to be removed.
    EXPECT_EQ(again.exitCode, now.contains("a@x.json") && !now.contains("a@x.png") ? 1 : 0) << again.out;
    for (const auto& [name, bytes] : known.after) EXPECT_EQ(bytesOf(folder / change.folder / name), bytes) << name;
  });
}

INSTANTIATE_TEST_SUITE_P(Of, KilledApproval,
                         Combine(Values(kSuite),
                                 Values(Fault{"link", "parent", "kill"}, Fault{"rename", "parent", "kill"})),
                         faultOf);

}  // namespace
}  // namespace poinsot::faults
