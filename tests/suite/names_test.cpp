// SPDX-License-Identifier: Apache-2.0
// No two files of a golden suite may be one. The test draws suites of two tests at random from all kinds of names.
// The expected verdict comes from the definition: no path may appear twice in the list of both tests' files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <random>
#include <set>

#include "core/text.h"
#include "suite/checks.h"
#include "support/scratch_folder.h"

namespace poinsot::suite {
namespace {

using ::testing::HasSubstr;

/// One [[test]], with its files by docs/golden.md.
struct Kind {
  std::string name;
  std::string extension;  ///< of its image; ".toml" for a scene
  std::vector<std::string> times;
  std::string variant;

  bool isScene() const { return extension == ".toml"; }

  std::string toml() const {
    std::string text =
        "[[test]]\nname = '" + name + "'\n" + (isScene() ? "scene" : "image") + " = 'f" + extension + "'\n";
    if (!variant.empty()) text += "variant = '" + variant + "'\n";
    if (times.empty()) return text;
    text += "times = [";
    for (const std::string& time : times) text += time + ", ";
    return text + "]\n";
  }

  std::vector<std::string> cases() const {
    if (times.size() < 2) return {name};
    std::vector<std::string> names;
    for (const std::string& time : times) names.push_back(name + "_t" + (time == "'0 s'" ? "0" : time));
    return names;
  }

  /// Returns the files below the folder of references.
  std::vector<std::string> references() const {
    std::vector<std::string> files;
    const auto add = [&](const std::string& picture, const std::string& mark) {
      const auto dot = std::min(picture.rfind('.'), picture.size());
      const std::string stem = picture.substr(0, dot) + mark;
      files.insert(files.end(), {stem + picture.substr(dot), stem + ".json"});
    };
    const std::string ending = isScene() ? ".png" : extension;
    for (const std::string& one : cases()) add(one + ending, "");
    if (!variant.empty()) add(name + ending, "@soft");
    return files;
  }

  /// Returns the files below the folder of new pictures.
  std::vector<std::string> written() const {
    std::vector<std::string> files;
    for (const std::string& one : cases()) {
      if (isScene()) files.push_back(one + ".png");
      files.insert(files.end(), {one + ".flip.png", one + ".difference.png"});
    }
    return files;
  }
};

std::vector<Kind> allKinds() {
  std::vector<Kind> kinds;
  for (const char* name : {"a", "b", "A", "a_t0", "a_t0.3", "A_t0", "a.flip", "a.difference", "a.Flip.flip",
                           "a@soft", "a_t0@soft", "a@softer", "a.json", "x/a", "x/a.flip"}) {
    using Times = std::vector<std::string>;
    for (const Times& times : {Times{}, Times{"0"}, Times{"0", "0.3"}, Times{"0.1", "0.1"}, Times{"0", "'0 s'"}})
      kinds.push_back({name, ".toml", times, ""});
    for (const char* extension : {".png", ".PNG", ".mp4", "", ".json"})
      for (const char* variant : {"", "soft", "soft!"})  // both are "soft" in the name of a file
        kinds.push_back({name, extension, {}, variant});
  }
  return kinds;
}

class GoldenNames : public ::testing::Test {
 protected:
  std::string errorOf(const std::string& suite) const try {
    const GoldenManifest manifest =
        parseGoldenManifest("references = 'ref'\n" + suite, folder_.path() / "golden.toml");
    GoldenRequest request;
    request.output = folder_.path() / "out";
    expectFilesApart(manifest, casesOf(manifest, request), request.output);
    return "";
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kScene) << error.what();
    return error.what();
  }

  /// Compares verdicts on `count` random suites of two tests with the definition.
  void compare(int count, bool ignoresCase) const {
    const auto isOneFile = [&](std::vector<std::string> files, const std::vector<std::string>& more) {
      files.insert(files.end(), more.begin(), more.end());
      if (ignoresCase) std::ranges::transform(files, files.begin(), core::lowered);
      return std::set(files.begin(), files.end()).size() < files.size();
    };
    const std::vector<Kind> kinds = allKinds();
    std::mt19937 random(33);
    int refused = 0;
    for (int i = 0; i < count; ++i) {
      const Kind &first = kinds[random() % kinds.size()], &second = kinds[random() % kinds.size()];
      const std::string suite = first.toml() + second.toml(), error = errorOf(suite);
      EXPECT_EQ(!error.empty(), first.name == second.name || isOneFile(first.references(), second.references()) ||
                                    isOneFile(first.written(), second.written()))
          << suite << error;
      if (error.empty()) continue;
      ++refused;
      EXPECT_THAT(error, HasSubstr(folder_.path().native() + "/golden.toml:")) << suite;
      EXPECT_THAT(error, HasSubstr("line ")) << suite;
    }
    EXPECT_GT(refused, count / 10);
    EXPECT_LT(refused, count - count / 10);
  }

  ScratchFolder folder_;
};

TEST_F(GoldenNames, AreRejectedIfTwoTestsWouldShareAFile) { compare(4000, false); }

// A second name of each folder, in capitals, stands in for a file system that ignores case.
TEST_F(GoldenNames, AreComparedWithoutCaseIfTheFileSystemIgnoresIt) {
  for (const char* const names : {"ref REF", "out OUT"}) {
    const std::string both = names;
    std::filesystem::create_directory(folder_.path() / both.substr(0, 3));
    std::filesystem::create_directory_symlink(both.substr(0, 3), folder_.path() / both.substr(4));
  }
  compare(1000, true);
}

TEST_F(GoldenNames, ErrorsNameTheLinesOfBothTests) {
  const std::string scene = "scene = 's.toml'\n";
  EXPECT_THAT(
      errorOf("[[test]]\nname = 'a'\ntimes = [0, 0.3]\n" + scene + "[[test]]\nname = 'a_t0'\n" + scene),
      HasSubstr("golden.toml:6:1: error: test.name: " + folder_.path().native() +
                "/ref/a_t0.png would be the reference of test 'a' (line 2) and the reference of test 'a_t0' "
                "(line 6); choose other names or times"));
  EXPECT_THAT(
      errorOf("[[test]]\nimage = 'x.json'\n"),
      HasSubstr("ref/x.json would be the reference and the description of test 'x' (line 2); give the image"));
}

// A link in the folder of new pictures gives one file two names.
TEST_F(GoldenNames, AreComparedAfterResolvingLinks) {
  std::filesystem::create_directories(folder_.path() / "out/x");
  std::filesystem::create_directory_symlink("x", folder_.path() / "out/y");
  const std::string x = "[[test]]\nname = 'x/a'\nscene = 's.toml'\n",
                    y = "[[test]]\nname = 'y/a'\nscene = 's.toml'\n";
  EXPECT_THAT(errorOf(x + y), HasSubstr("out/y/a.png would be the new picture of test 'x/a' (line 2) and"));
  EXPECT_EQ(errorOf(x), "");
}

}  // namespace
}  // namespace poinsot::suite
