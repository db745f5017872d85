// SPDX-License-Identifier: Apache-2.0
// A finished film that was damaged is made again by `render --resume`, with the bytes that it had. Every kind of
// damage is tried in process, by FilmDamage in tests/output.
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

// Two kinds of damage for each kind of film, so that each is done to two or more.
TEST_P(DamagedFilm, IsMadeAgain) {
  EXPECT_EQ(status().out, film_.name + ": complete\n");
  for (const int more : {0, 1}) {
    const auto& [name, damage] = kDamages[(static_cast<std::size_t>(GetParam()) + more) % std::size(kDamages)];
    SCOPED_TRACE(name);
    std::string damaged = whole_;
    damage(damaged);
    put(damaged);
    const RunResult told = status();
    EXPECT_EQ(told.exitCode, 1);
    EXPECT_EQ(told.out, film_.name + ": not as it was written; render with --resume makes it again\n");
    const RunResult made = render({"--resume", "--progress", "plain"});
    EXPECT_EQ(made.exitCode, 0) << made.err;
    EXPECT_THAT(made.err,
                HasSubstr("note: " + film_.name + " was there, but not as it was written; it was made again"));
    EXPECT_THAT(made.err, HasSubstr(film_.name + " is ready (6 frames, "));
    EXPECT_TRUE(bytes() == whole_);
  }
}

TEST_P(DamagedFilm, IsNotMadeAgainIfItIsNotDamaged) {
  const RunResult again = render({"--resume", "--progress", "plain"});
  EXPECT_THAT(again.err, HasSubstr("(6 frames, 6 of them were there already, "));
  EXPECT_THAT(again.err, testing::Not(HasSubstr("note: ")));
}

INSTANTIATE_TEST_SUITE_P(Each, DamagedFilm,
                         testing::ValuesIn(output::filmContainers().begin(), output::filmContainers().end()),
                         [](const auto& tested) { return std::string(nameOf(tested.param)); });

class DamagedFilmOfEachSort : public DamagedFilm {};

TEST_P(DamagedFilmOfEachSort, IsMadeOfTheSegmentsThatAreThere) {
  ASSERT_EQ(render({"--keep"}).exitCode, 0);
  put(whole_.substr(0, whole_.size() - 1));
  const RunResult made = render({"--resume", "--progress", "plain"});
  EXPECT_THAT(made.err, HasSubstr(film_.name + " is ready (6 frames, 6 of them were there already, "));
  EXPECT_TRUE(bytes() == whole_);
}

// Nothing in it says that it was ours.
TEST_P(DamagedFilmOfEachSort, IsRefusedIfNothingOfItIsLeft) {
  const std::string text(whole_.size(), 'x');
  put(text);
  const RunResult refused = render({"--resume"});
  EXPECT_EQ(refused.exitCode, 4);
  EXPECT_THAT(refused.err, HasSubstr("exists and was not written by poinsot; --force replaces it"));
  EXPECT_TRUE(bytes() == text);
  EXPECT_EQ(render({"--resume", "--force"}).exitCode, 0);
  EXPECT_TRUE(bytes() == whole_);
}

// One that is joined of its segments, and one that is encoded of them.
INSTANTIATE_TEST_SUITE_P(Two, DamagedFilmOfEachSort,
                         testing::Values(output::FilmContainer::kMp4, output::FilmContainer::kGif),
                         [](const auto& tested) { return std::string(nameOf(tested.param)); });

}  // namespace
}  // namespace poinsot::faults
