// SPDX-License-Identifier: Apache-2.0
// A scene that `new` writes is valid, and remains valid with each line that it offers as an alternative.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "support/program_run.h"

namespace poinsot {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kScenes = std::string("POINSOT_SCENES=") + POINSOT_SOURCE_DIR "/scenes";

class NewCommand : public testing::Test {
 protected:
  RunResult run(const std::vector<std::string>& words) const {
    return poinsot::run(folder_, words, Stdout::kFile, {kScenes});
  }
  std::vector<std::string> linesOf(const std::string& file) const {
    std::istringstream stream(bytesOf(folder_ / file));
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }
  void write(const std::string& file, const std::vector<std::string>& lines) const {
    std::ofstream stream(folder_ / file);
    for (const std::string& line : lines) stream << line << '\n';
  }

  ScratchFolder folder_;
};

TEST_F(NewCommand, WritesAValidSceneAndPrintsTheNextCommand) {
  const auto made = run({"new", "my_book"});
  EXPECT_EQ(made.exitCode, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("\n  poinsot render my_book.toml\n"));
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("my_book.toml", "poinsot.schema.json"));
  EXPECT_EQ(run({"check", "my_book.toml"}).exitCode, 0);
  EXPECT_THAT(bytesOf(folder_ / "my_book.toml"), StartsWith("#:schema ./poinsot.schema.json\n# my_book: "));
  EXPECT_THAT(bytesOf(folder_ / "my_book.toml"), HasSubstr("title = \"My book\"\n"));
  EXPECT_EQ(bytesOf(folder_ / "poinsot.schema.json"), run({"schema"}).out);
}

// Uncomments one line "# key = value" at a time. Below "# instead of", the test removes the lines above in the
// table.
TEST_F(NewCommand, OffersOnlyValidAlternatives) {
  run({"new", "a"});
  const auto lines = linesOf("a.toml");
  const std::regex offer("# ([a-z_]+ = .*)");
  int offers = 0;
  for (std::size_t i = 2; i < lines.size(); ++i) {
    std::smatch found;
    if (!std::regex_match(lines[i], found, offer)) continue;
    ++offers;
    auto own = lines;
    own[i] = found[1];
    bool alternative = false;
    for (std::size_t j = i; --j > 0 && !lines[j].starts_with('[');) {
      alternative |= lines[j].starts_with("# instead of");
      if (alternative) own[j].clear();
    }
    write("b.toml", own);
    const auto checked = run({"check", "b.toml"});
    EXPECT_EQ(checked.exitCode, 0) << checked.err;
  }
  EXPECT_GE(offers, 10);
}

TEST_F(NewCommand, StartsFromEverySceneOfTheGallery) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(POINSOT_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    const std::string name = entry.path().stem();
    ASSERT_EQ(run({"new", "own", "--from", name, "--force"}).exitCode, 0) << name;
    EXPECT_EQ(bytesOf(folder_ / "own.toml"), "#:schema ./poinsot.schema.json\n" + bytesOf(entry.path()));
    const auto checked = run({"check", "own.toml"});
    EXPECT_EQ(checked.exitCode, 0) << "it names a file that is not there: " << checked.err;
    ++scenes;
  }
  EXPECT_GE(scenes, 20);
}

TEST_F(NewCommand, ReplacesAFileOnlyWithForce) {
  std::ofstream(folder_ / "a.toml") << "mine";
  const auto refused = run({"new", "a.toml"});
  EXPECT_EQ(refused.exitCode, 4);
  EXPECT_EQ(refused.err, "poinsot: error: a.toml: already exists; --force replaces it\n");
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.toml"));
  EXPECT_EQ(bytesOf(folder_ / "a.toml"), "mine");
  EXPECT_EQ(run({"new", "a.toml", "--force"}).exitCode, 0);
  EXPECT_EQ(run({"check", "a.toml"}).exitCode, 0);
}

TEST_F(NewCommand, ReportsUnknownScenesAndMissingFolders) {
  EXPECT_THAT(run({"new", "a", "--from", "footbal"}).err,
              HasSubstr("has no scene 'footbal'; did you mean 'football'?"));
  EXPECT_EQ(run({"new", "a", "--from", "footbal"}).exitCode, 2);
  EXPECT_EQ(run({"new", ""}).exitCode, 2);
  const auto nowhere = run({"new", "no where/a"});
  EXPECT_EQ(nowhere.exitCode, 4);
  EXPECT_EQ(nowhere.err, "poinsot: error: no where: no such folder; make it with: mkdir -p 'no where'\n");
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre());
}

// The name appears in a comment and in a title, which may contain commands and mathematics.
TEST_F(NewCommand, WritesAValidSceneForAnyName) {
  for (const char* name :
       {"-x", "a b", "$\\alpha", "\"q\"", "a\nb", "\x1b[2J", "\u202e", "%", "@TITLE@", "Ünal"}) {
    const auto made = run({"new", "--force", "--", name});
    ASSERT_EQ(made.exitCode, 0) << name << made.err;
    const auto checked = run({"check", "--", std::string(name) + ".toml"});
    EXPECT_EQ(checked.exitCode, 0) << name << checked.err;
  }
}

}  // namespace
}  // namespace poinsot
