// SPDX-License-Identifier: Apache-2.0
// Damaged files must give either a scene or SceneErrors. Seeds are fixed, so that a failure repeats.
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "scene_testing.h"

namespace poinsot::scene {
namespace {

std::string textOf(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(dataPath(name)).rdbuf();
  return text.str();
}

std::string validText() { return textOf("full.toml"); }

enum class Verdict { kAccepted, kRefused };

/// Returns whether a text is accepted or refused with SceneErrors. Any other exception ends the test.
Verdict verdictOn(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parseScene(text, dataPath("fuzz.toml"), overrides);
    return Verdict::kAccepted;
  } catch (const SceneErrors& errors) {
    EXPECT_FALSE(errors.problems().empty());
    for (const char c : std::string_view(errors.what()))
      EXPECT_TRUE(c == '\n' || (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f)) << errors.what();
    return Verdict::kRefused;
  }
}

TEST(Fuzz, EveryPrefixOfASceneIsAcceptedOrRejected) {
  const std::string text = validText();
  ASSERT_GT(text.size(), 1000u);
  int accepted = 0;
  for (std::size_t length = 0; length <= text.size(); ++length)
    accepted += verdictOn(text.substr(0, length)) == Verdict::kAccepted;
  EXPECT_GT(accepted, 10);  // after [motion] each whole line completes a scene
  EXPECT_EQ(verdictOn(text), Verdict::kAccepted);
}

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  /// Applies one to `most` edits.
  std::string operator()(std::string text, unsigned most) {
    const unsigned edits = 1 + below(most);
    for (unsigned i = 0; i < edits && !text.empty(); ++i) edit(text);
    return text;
  }

 private:
  // std::mt19937 gives the same numbers everywhere; the distribution classes do not.
  unsigned below(std::size_t n) { return static_cast<unsigned>(random_() % n); }

  const char* piece() {
    static constexpr const char* kPieces[] = {"[",
                                              "]",
                                              "{",
                                              "}",
                                              "\"",
                                              "'",
                                              "\"\"\"",
                                              "'''",
                                              "=",
                                              ".",
                                              ",",
                                              "#",
                                              "\n",
                                              "\r",
                                              "\\",
                                              "nan",
                                              "inf",
                                              "1e999",
                                              "-0",
                                              "1e-320",
                                              "0x7f",
                                              "true",
                                              "99999999999999999999",
                                              "[[",
                                              "]]",
                                              "\\u202e",
                                              "\xff",
                                              "\xc2\x9b",
                                              "\x1b",
                                              "ω",
                                              "body",
                                              "show.plane",
                                              "1979-05-27",
                                              "\xef\xbb\xbf",
                                              "= =",
                                              "{a=1}",
                                              "rpm",
                                              "kg^-9"};
    return kPieces[below(std::size(kPieces))];
  }

  void edit(std::string& text) {
    const std::size_t at = below(text.size());
    const std::size_t length = 1 + below(12);
    switch (below(6)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, piece());
        break;
      case 3:
        text.replace(at, length, piece());
        break;
      case 4:
        text.insert(at, text.substr(below(text.size()), 4 * length));
        break;
      default:
        text[at] = static_cast<char>(text[at] ^ (1 << below(7)));
        break;
    }
  }

  std::mt19937 random_;
};

// Measured with this seed: 139 of 6000 are still scenes, so that both outcomes occur.
TEST(Fuzz, MutatedScenesAreAcceptedOrRejected) {
  const std::string text = validText();
  Mutator mutate(20240711);
  int accepted = 0;
  for (int i = 0; i < 6000; ++i) accepted += verdictOn(mutate(text, 3)) == Verdict::kAccepted;
  EXPECT_GT(accepted, 100);
  EXPECT_LT(accepted, 5900);
}

// Measured with this seed: 80 of 3000 are still scenes.
TEST(Fuzz, MutatedScenesWithPartsAreAcceptedOrRejected) {
  const std::string text = textOf("driven.toml");
  EXPECT_EQ(verdictOn(text), Verdict::kAccepted);
  Mutator mutate(7);
  int accepted = 0;
  for (int i = 0; i < 3000; ++i) accepted += verdictOn(mutate(text, 3)) == Verdict::kAccepted;
  EXPECT_GT(accepted, 50);
  EXPECT_LT(accepted, 2950);
}

// Measured with this seed: 283 of 4000 are accepted.
TEST(Fuzz, OverridesAreAcceptedOrRefused) {
  Mutator mutate(3);
  const char* valid[] = {"show.plane={opacity=0.5, grid=false}", "time.fps=\"30000/1001\"", "show.title=A racket",
                         "body.principal_moments=[\"1 kg m^2\", 2, 2.5]"};
  int accepted = 0;
  for (int i = 0; i < 4000; ++i) accepted += verdictOn(kMinimal, {mutate(valid[i % 4], 2)}) == Verdict::kAccepted;
  EXPECT_GT(accepted, 100);
  EXPECT_LT(accepted, 3900);
}

}  // namespace
}  // namespace poinsot::scene
