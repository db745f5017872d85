// SPDX-License-Identifier: Apache-2.0
// Tests the search for a film that is not larger than a limit, with encoders whose sizes are formulas.
#include "job/size_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace poinsot::job {
namespace {

using output::FilmContainer;

using Encoder = std::function<double(const FilmChoice&)>;

const FilmChoice kHd{{1920, 1080}, {30, 1}, 255, 18};
const FilmChoice kSmall{{480, 270}, {30, 1}, 255, 18};

/// Size of a GIF by three powers. The powers differ from those that the search assumes.
Encoder gif(double bytesPerPixel, double pixelPower, double ratePower = 0.85, double colorPower = 0.2) {
  return [=](const FilmChoice& film) {
    const double pixels = film.size.width * film.size.height;
    return bytesPerPixel * std::pow(pixels, pixelPower) * std::pow(film.fps.value(), ratePower) *
           std::pow(film.colors, colorPower);
  };
}

struct Outcome {
  std::optional<FilmChoice> film;  ///< the film that was written
  std::int64_t bytes = 0;
  int encodes = 0;
  FilmChoice smallest = {};
};

Outcome searched(const FilmChoice& asked, FilmContainer container, const Encoder& encoder, double most_bytes,
                 const FixedProperties& fixed = {}) {
  SizeSearch search(asked, container, fixed, static_cast<std::int64_t>(most_bytes));
  Outcome outcome;
  while (const auto trial = search.next()) {
    const auto bytes = static_cast<std::int64_t>(encoder(trial->film));
    ++outcome.encodes;
    if (outcome.encodes > 10) break;
    if (trial->accepted.contains(bytes)) {
      outcome.film = trial->film;
      outcome.bytes = bytes;
      return outcome;
    }
    search.add(bytes);
  }
  outcome.smallest = search.smallest().film;
  return outcome;
}

double ratio(const FilmChoice& asked, const Encoder& encoder, double factor) { return encoder(asked) * factor; }

TEST(SizeSearch, MakesASmallFilmThatFitsOnce) {
  const Outcome outcome = searched(kSmall, FilmContainer::kGif, gif(0.01, 0.8), 1e9);
  EXPECT_EQ(outcome.film, kSmall);
  EXPECT_EQ(outcome.encodes, 1);
}

// A large film is first tried in a small size, so two films are made.
TEST(SizeSearch, WritesALargeFilmAsAskedIfItFits) {
  for (const double power : {0.55, 0.75, 1.0})
    for (const double share : {1.0, 1.01, 1.5, 100.0}) {
      const Encoder encoder = gif(0.01, power);
      const Outcome outcome = searched(kHd, FilmContainer::kGif, encoder, ratio(kHd, encoder, share) + 1);
      EXPECT_EQ(outcome.film, kHd) << power << " " << share;
      EXPECT_EQ(outcome.encodes, 2) << power << " " << share;
    }
}

TEST(SizeSearch, FitsAndUsesMostOfTheLimit) {
  for (const FilmChoice& asked : {kHd, kSmall, FilmChoice{{1080, 1920}, {25, 1}, 64, 18}})
    for (const double power : {0.6, 0.78, 0.95})
      for (const double share : {0.9, 0.5, 0.2}) {
        const Encoder encoder = gif(0.01, power);
        const double most = ratio(asked, encoder, share);
        const Outcome outcome = searched(asked, FilmContainer::kGif, encoder, most);
        ASSERT_TRUE(outcome.film) << power << " " << share;
        EXPECT_LE(outcome.bytes, most);
        EXPECT_GT(outcome.bytes, 0.6 * most) << power << " " << share;
        EXPECT_LE(outcome.encodes, 4);  // three trials, and the best of them again
        EXPECT_LE(outcome.film->size.width, asked.size.width);
        EXPECT_LE(outcome.film->fps.value(), asked.fps.value());
        EXPECT_LE(outcome.film->colors, asked.colors);
      }
}

// Each film is up to 15 % larger or smaller than the formula, but always has the same size.
TEST(SizeSearch, FitsDespiteNoise) {
  const Encoder smooth = gif(0.01, 0.8);
  const Encoder noisy = [&](const FilmChoice& film) {
    std::minstd_rand random(static_cast<unsigned>(film.size.width * 1000 + film.fps.num * 10 + film.colors));
    random.discard(3);
    return smooth(film) * std::uniform_real_distribution<double>(0.85, 1.15)(random);
  };
  for (double share = 0.02; share < 1; share += 0.005) {
    const double most = ratio(kHd, smooth, share);
    const Outcome outcome = searched(kHd, FilmContainer::kGif, noisy, most);
    ASSERT_TRUE(outcome.film) << share;
    EXPECT_LE(outcome.bytes, most) << share;
    EXPECT_LE(outcome.encodes, 4) << share;
  }
}

TEST(SizeSearch, EndsWithTheSmallestFilmIfNothingFits) {
  const Outcome outcome = searched(kHd, FilmContainer::kGif, gif(0.01, 0.8), 10);
  EXPECT_FALSE(outcome.film);
  EXPECT_LE(outcome.encodes, 2);
  EXPECT_EQ(outcome.smallest, (FilmChoice{{320, 180}, {10, 1}, 32, 18}));
}

TEST(SizeSearch, FindsTheSmallestFilmIfOnlyThatFits) {
  for (const double power : {0.6, 0.8, 1.0}) {
    const Encoder encoder = gif(0.01, power);
    const FilmChoice least{{320, 180}, {10, 1}, 32, 18};
    const Outcome outcome = searched(kHd, FilmContainer::kGif, encoder, encoder(least) + 1);
    EXPECT_EQ(outcome.film, least) << power;
    EXPECT_LE(outcome.encodes, 4) << power;
  }
}

TEST(SizeSearch, KeepsFixedProperties) {
  const Encoder encoder = gif(0.01, 0.8);
  const double half = ratio(kSmall, encoder, 0.5);
  const Outcome size = searched(kSmall, FilmContainer::kGif, encoder, half, {.size = true});
  ASSERT_TRUE(size.film);
  EXPECT_EQ(size.film->size, kSmall.size);
  const Outcome rate = searched(kSmall, FilmContainer::kGif, encoder, half, {.fps = true});
  ASSERT_TRUE(rate.film);
  EXPECT_EQ(rate.film->fps, kSmall.fps);
  const Outcome colors = searched(kSmall, FilmContainer::kGif, encoder, half, {.colors = true});
  ASSERT_TRUE(colors.film);
  EXPECT_EQ(colors.film->colors, kSmall.colors);
  const Outcome all =
      searched(kSmall, FilmContainer::kGif, encoder, half, {.size = true, .fps = true, .colors = true});
  EXPECT_FALSE(all.film);
  EXPECT_EQ(all.encodes, 1);
}

TEST(SizeSearch, RaisesTheRateFactorOfAnMp4) {
  const Encoder encoder = [](const FilmChoice& film) {
    return std::pow(film.size.width * film.size.height, 0.75) * std::pow(film.fps.value(), 0.4) *
           std::exp(-0.12 * film.crf);
  };
  const double most = ratio(kHd, encoder, 0.5);
  const Outcome outcome = searched(kHd, FilmContainer::kMp4, encoder, most);
  ASSERT_TRUE(outcome.film);
  EXPECT_GT(outcome.film->crf, kHd.crf);
  EXPECT_EQ(outcome.film->colors, kHd.colors);
  EXPECT_GT(outcome.bytes, 0.6 * most);
}

TEST(SmallerFilms, BeginWithTheFilmAsAskedAndAreNeverBetter) {
  for (const FilmContainer container : output::filmContainers()) {
    const auto films = smallerFilms(kHd, container, {});
    EXPECT_EQ(films.front(), kHd);
    for (const FilmChoice& film : films) {
      EXPECT_LE(film.size.width, 1920);
      EXPECT_GE(film.size.width, 320);
      EXPECT_EQ(film.size.height % 2, 0);
      EXPECT_NEAR(film.size.height, film.size.width * 9 / 16.0, 1);
      EXPECT_LE(film.fps.value(), 30);
      EXPECT_GE(film.fps.value(), 10);
      EXPECT_TRUE(film.crf >= 18 && film.crf <= 30);
      EXPECT_TRUE(film.colors >= 32 && film.colors <= 255);
    }
  }
}

TEST(SmallerFilms, HaveDelaysOfWholeHundredthsInAGif) {
  for (const FilmChoice& film : smallerFilms({{640, 360}, {50, 1}, 255, 18}, FilmContainer::kGif, {}))
    EXPECT_EQ(100 * film.fps.den % film.fps.num, 0) << film.fps.num << "/" << film.fps.den;
}

TEST(SmallerFilms, DivideTheRateOfOtherFilmsEvenly) {
  for (const FilmChoice& film : smallerFilms({{640, 360}, {30000, 1001}, 255, 18}, FilmContainer::kMp4, {}))
    EXPECT_EQ(30000 * film.fps.den % (1001 * film.fps.num), 0) << film.fps.num << "/" << film.fps.den;
}

TEST(SmallerFilms, KeepAFilmThatIsAlreadySmall) {
  const FilmChoice tiny{{160, 90}, {8, 1}, 16, 35};
  for (const FilmContainer container : output::filmContainers())
    EXPECT_EQ(smallerFilms(tiny, container, {}), std::vector{tiny});
}

}  // namespace
}  // namespace poinsot::job
