// SPDX-License-Identifier: Apache-2.0
// Every command refuses truncated or damaged files with a message, and nothing is lost (row F4 of the promises in
// SECURITY.md). The tests of each reader try damage at every byte (Fuzz, MeshFuzz, Png).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/program_run.h"

namespace poinsot {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

class DamagedInput : public testing::Test {
 protected:
  void SetUp() override { folder_.put("s.toml", kGoodScene); }

  void make(const std::vector<std::string>& words) {
    const RunResult made = run(folder_, words);
    ASSERT_EQ(made.exitCode, 0) << made.err;
  }

  /// Returns damaged copies of a file. At each of `places` positions, one copy is cut off and one has a changed
  /// byte.
  std::vector<std::string> damaged(const std::string& name, std::size_t places) const {
    const std::string whole = bytesOf(folder_ / name);
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < places; ++i) {
      const std::size_t at = i * whole.size() / places;
      texts.push_back(whole.substr(0, at));
      std::string turned = whole;
      turned[at] = static_cast<char>(turned[at] ^ 0x55);
      texts.push_back(turned);
    }
    return texts;
  }

  ScratchFolder folder_;
};

TEST_F(DamagedInput, SceneIsRejectedWithTheLine) {
  const auto texts = damaged("s.toml", 40);
  int refused = 0;
  for (const std::string& text : texts) {
    folder_.put("s.toml", text);
    const RunResult made = run(folder_, {"check", "s.toml"});
    ASSERT_THAT(made.exitCode, AnyOf(0, 2)) << text << made.err;
    if (made.exitCode != 2) continue;
    ++refused;
    EXPECT_THAT(made.err, testing::ContainsRegex("s.toml:[0-9]+:[0-9]+: error: ")) << text;
  }
  EXPECT_GT(refused, 20);
}

TEST_F(DamagedInput, PictureIsRejected) {
  make({"still", "s.toml", "-o", "a.png", "--size", "64x36", "--quiet"});
  for (const std::string& bytes : damaged("a.png", 25)) {
    folder_.put("b.png", bytes);
    const RunResult made = run(folder_, {"diff", "a.png", "b.png"});
    EXPECT_EQ(made.exitCode, 4) << made.out;
    EXPECT_THAT(made.err, HasSubstr("b.png"));
  }
}

TEST_F(DamagedInput, FilmGetsAVerdictOrAnError) {
  make({"render", "s.toml", "-o", "a.mp4", "--size", "64x36", "--frames", "0-5", "--quiet"});
  for (const std::string& bytes : damaged("a.mp4", 25)) {
    folder_.put("b.mp4", bytes);
    const RunResult made = run(folder_, {"diff", "a.mp4", "b.mp4"});
    EXPECT_THAT(made.exitCode, AnyOf(0, 1, 4)) << made.err;
    if (made.exitCode == 4) {
      EXPECT_THAT(made.err, HasSubstr("b.mp4"));
    }
  }
}

TEST_F(DamagedInput, TableIsRejectedOrGraded) {
  make({"trajectory", "s.toml", "--rate", "5", "-o", "a.csv"});
  for (const std::string& text : damaged("a.csv", 25)) {
    folder_.put("b.csv", text);
    const RunResult made = run(folder_, {"grade", "s.toml", "b.csv"});
    EXPECT_THAT(made.exitCode, AnyOf(0, 4)) << made.err;
    if (made.exitCode == 4) {
      EXPECT_THAT(made.err, HasSubstr("b.csv"));
    }
  }
}

TEST_F(DamagedInput, GoldenTomlIsRejected) {
  folder_.put("golden.toml", "size = [64, 36]\n[[test]]\nname = 'one'\nscene = 's.toml'\ntimes = [0.5, 1]\n");
  for (const std::string& text : damaged("golden.toml", 25)) {
    folder_.put("g.toml", text);
    const RunResult made = run(folder_, {"golden", "g.toml", "--list"});
    EXPECT_THAT(made.exitCode, AnyOf(0, 2, 4)) << made.err;
    if (made.exitCode != 0) {
      EXPECT_THAT(made.err, HasSubstr("g.toml"));
    }
  }
}

// If a killed render left damaged files, the next render starts anew and makes the same bytes.
TEST_F(DamagedInput, SegmentsAreRenderedAgain) {
  const std::vector<std::string> words{"render",   "s.toml",   "-o",        "a.mp4",   "--size",
                                       "64x36",    "--frames", "0-5",       "--quiet", "--keep",
                                       "--resume", "--force",  "--segment", "3"};
  make(words);
  const std::string film = bytesOf(folder_ / "a.mp4");
  const std::filesystem::path work = folder_ / ".a.mp4.poinsot";
  std::vector<std::string> names;
  for (const std::string& name : namesIn(work)) names.push_back(".a.mp4.poinsot/" + name);
  ASSERT_EQ(names.size(), 5u);  // job.json, two segments, two records
  for (const std::string& name : names)
    for (const std::string& text : damaged(name, 2)) {
      folder_.put(name, text);
      std::filesystem::remove(folder_ / "a.mp4");
      EXPECT_THAT(run(folder_, {"status", "a.mp4"}).exitCode, AnyOf(0, 1, 4)) << name;
      make(words);
      EXPECT_EQ(bytesOf(folder_ / "a.mp4"), film) << name;
    }
}

}  // namespace
}  // namespace poinsot
