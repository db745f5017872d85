// SPDX-License-Identifier: Apache-2.0
// `render --resume` makes a damaged film again, with the same bytes. FilmDamage in tests/output tries every kind
// of damage in process.
#include <gmock/gmock.h>

#include <fstream>

#include "faults/tiny_film.h"
#include "output/film_format.h"

namespace poinsot::faults {
namespace {

using testing::HasSubstr;

struct Damage {
  const char* name;
  void (*damage)(std::string& bytes);
};

constexpr Damage kDamages[] = {
    {"a header of zeros", [](std::string& bytes) { bytes.replace(0, 8, 8, '\0'); }},
    {"a flipped bit",
     [](std::string& bytes) { bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1); }},
    {"its last third missing", [](std::string& bytes) { bytes.resize(bytes.size() * 2 / 3); }},
    {"a byte appended", [](std::string& bytes) { bytes += '\0'; }},
};

class DamagedFilm : public testing::TestWithParam<output::FilmContainer> {
 protected:
  DamagedFilm() : film_{"t." + std::string(nameOf(GetParam())), 0.6} {
    folder_.put("tiny.toml", kTinyScene);
    EXPECT_EQ(render({}).exitCode, 0);
    whole_ = bytes();
  }

  RunResult render(const std::vector<std::string>& more) const {
    return run(folder_, renderArguments(film_, more));
  }
  std::string bytes() const { return bytesOf(folder_ / film_.name); }
  void put(const std::string& bytes) const { std::ofstream(folder_ / film_.name, std::ios::binary) << bytes; }
  RunResult status() const { return run(folder_, {"status", film_.name}); }

  ScratchFolder folder_;
  Output film_;
  std::string whole_;
};

// Tries two kinds of damage for each kind of film, so that each kind is tried at least twice.
TEST_P(DamagedFilm, IsRenderedAgain) {
  EXPECT_EQ(status().out, film_.name + ": complete\n");
  for (const int more : {0, 1}) {
    const auto& [name, damage] = kDamages[(static_cast<std::size_t>(GetParam()) + more) % std::size(kDamages)];
    SCOPED_TRACE(name);
    std::string damaged = whole_;
    damage(damaged);
    put(damaged);
    const RunResult told = status();
    EXPECT_EQ(told.exitCode, 1);
    EXPECT_EQ(told.out,
              film_.name + ": damaged or changed after it was written; render with --resume makes it again\n");
    const RunResult made = render({"--resume", "--progress", "plain"});
    EXPECT_EQ(made.exitCode, 0) << made.err;
    EXPECT_THAT(made.err, HasSubstr("note: " + film_.name +
                                    " was damaged or changed after it was written, so it was made again"));
    EXPECT_THAT(made.err, HasSubstr(film_.name + " is ready (6 frames, "));
    EXPECT_TRUE(bytes() == whole_);
  }
}

TEST_P(DamagedFilm, UndamagedFilmIsNotRenderedAgain) {
  const RunResult again = render({"--resume", "--progress", "plain"});
  EXPECT_THAT(again.err, HasSubstr("(6 frames, 6 of them already existed, "));
  EXPECT_THAT(again.err, testing::Not(HasSubstr("note: ")));
}

INSTANTIATE_TEST_SUITE_P(Each, DamagedFilm,
                         testing::ValuesIn(output::filmContainers().begin(), output::filmContainers().end()),
                         [](const auto& tested) { return std::string(nameOf(tested.param)); });

class DamagedMp4OrGif : public DamagedFilm {};

TEST_P(DamagedMp4OrGif, IsJoinedAgainFromKeptSegments) {
  ASSERT_EQ(render({"--keep"}).exitCode, 0);
  put(whole_.substr(0, whole_.size() - 1));
  const RunResult made = render({"--resume", "--progress", "plain"});
  EXPECT_THAT(made.err, HasSubstr(film_.name + " is ready (6 frames, 6 of them already existed, "));
  EXPECT_TRUE(bytes() == whole_);
}

// The file contains no sign that poinsot wrote it.
TEST_P(DamagedMp4OrGif, IsNotReplacedIfItIsUnrecognisable) {
  const std::string text(whole_.size(), 'x');
  put(text);
  const RunResult refused = render({"--resume"});
  EXPECT_EQ(refused.exitCode, 4);
  EXPECT_THAT(refused.err, HasSubstr("exists and was not written by poinsot; --force replaces it"));
  EXPECT_TRUE(bytes() == text);
  EXPECT_EQ(render({"--resume", "--force"}).exitCode, 0);
  EXPECT_TRUE(bytes() == whole_);
}

// One film is joined from its segments, the other is encoded from them.
INSTANTIATE_TEST_SUITE_P(Each, DamagedMp4OrGif,
                         testing::Values(output::FilmContainer::kMp4, output::FilmContainer::kGif),
                         [](const auto& tested) { return std::string(nameOf(tested.param)); });

}  // namespace
}  // namespace poinsot::faults
