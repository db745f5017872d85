// SPDX-License-Identifier: Apache-2.0
// Compares what poinsot explains about keys of golden.toml with the reader of such files and with the page in
// docs/.
#include "suite/explanation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "suite/manifest.h"
#include "support/scratch_folder.h"
#include "support/text_of.h"

namespace poinsot::suite {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::vector<std::string> titles(std::string_view word) {
  std::vector<std::string> all;
  for (const scene::Explanation& explanation : explainGolden(word)) all.push_back(explanation.title);
  return all;
}

/// Returns a whole manifest around a key with its example.
std::string manifestWith(const GoldenKey& key) {
  const std::string line = std::string(key.name) + " = " + key.example + "\n", table = key.table;
  const std::string image = "[[test]]\nimage = 'x.png'\n", scene = "[[test]]\nscene = 'scenes/a.toml'\n";
  if (table.empty()) return line + image;
  if (table == "rule")
    return "[rule]\n" + line + (key.name == std::string("reason") ? "" : "reason = 'x'\n") + image;
  if (key.name == std::string("scene") || key.name == std::string("image")) return "[[test]]\n" + line;
  const bool ofScenes = std::string("times size height set").find(key.name) != std::string::npos;
  return (ofScenes ? scene : image) + line;
}

TEST(GoldenExplanation, ExamplesAreAccepted) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "scenes");
  folder.put("scenes/a.toml", "");
  for (const GoldenKey& key : goldenKeys()) {
    if (!*key.example) continue;  // [[test]] itself, which every manifest has
    EXPECT_NO_THROW(parseGoldenManifest(manifestWith(key), folder / "golden.toml")) << manifestWith(key);
  }
}

TEST(GoldenExplanation, FindsEveryKeyByItsPathAndByItsName) {
  for (const GoldenKey& key : goldenKeys()) {
    EXPECT_THAT(titles(pathOf(key)), ::testing::Contains(pathOf(key)));
    EXPECT_THAT(titles(key.name), ::testing::Contains(pathOf(key)));
  }
  EXPECT_THAT(titles("golden.test.image"), ElementsAre("golden.test.image"));
  EXPECT_THAT(titles("test.rule.flip_max"), ElementsAre("golden.rule.flip_max"));
  EXPECT_THAT(titles("flip_max"), ElementsAre("golden.rule.flip_max"));
  EXPECT_THAT(titles("golden.size"), ElementsAre("golden.size"));
  for (const char* word : {"golden", "golden.toml"}) EXPECT_THAT(titles(word), ElementsAre("golden.toml"));
  EXPECT_THAT(titles("[[test]]"), ElementsAre("[[test]] of golden.toml", "golden.test"));
  EXPECT_THAT(titles("rule"), ElementsAre("[rule] of golden.toml", "golden.rule", "golden.test.rule"));
  EXPECT_THAT(titles("golden.flip_max"), IsEmpty());  // not a key at the top
  EXPECT_THAT(titles("camera"), IsEmpty());
}

constexpr const char* kUpdate = "POINSOT_UPDATE_DOCS=1 ctest --test-dir build -R GoldenExplanation.MatchesTheDocs";

// docs/golden.md is committed, so that it can be read without building. This test keeps its table of keys correct.
TEST(GoldenExplanation, MatchesTheDocs) {
  const std::string path = POINSOT_SOURCE_DIR "/docs/golden.md", begin = "<!-- golden keys -->\n",
                    end = "<!-- end -->";
  std::string page = textOf(path);
  const std::size_t from = page.find(begin) + begin.size(), to = page.find(end, from);
  ASSERT_LE(from, to);
  const std::string wanted = goldenKeysMarkdown();
  const bool same = page.substr(from, to - from) == wanted;
  if (std::getenv("POINSOT_UPDATE_DOCS"))
    std::ofstream(path) << page.replace(from, to - from, wanted);
  else
    EXPECT_TRUE(same) << "docs/golden.md differs from the table of keys; update it with\n  " << kUpdate;
}

}  // namespace
}  // namespace poinsot::suite
