// SPDX-License-Identifier: Apache-2.0
#include "job/size_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/expect.h"
#include "scene/limits.h"

namespace poinsot::job {
namespace {

using output::FilmContainer;

constexpr int kLeastWidth = 320;   // type in a narrower picture is hard to read
constexpr int kWidthStep = 32;     // keeps the heights of 16:9 even
constexpr double kLeastRate = 10;  // frames per second; slower films look like slides
constexpr int kWorstCrf = 30;      // thin lines get lost above
constexpr int kCrfStep = 2;
constexpr int kPalettes[] = {128, 64, 32};
// Frame rates of a GIF whose delays are whole hundredths of a second: 4, 5, 8 and 10 of them.
constexpr core::Rational kGifRates[] = {{25, 1}, {20, 1}, {25, 2}, {10, 1}};

constexpr std::size_t kMostTrials = 3;
constexpr int kProbePixels = 640 * 360;
constexpr double kGoodShare = 0.7;                // share of the limit that is worth no further trial
constexpr double kAim = 0.93, kCarefulAim = 0.8;  // shares of the limit
// A film with n times the pixels has at least n^0.5 times the bytes. Measured: 0.59 to 0.88.
constexpr double kLeastPixelPower = 0.5;

/// Powers with which the size of a file grows, and weights of the squared losses of quality. A step of the rate
/// factor counts as a factor e. Measured for three scenes of the gallery, from 320x180 to 960x540.
struct Model {
  double pixels, rate, colors, crf;
  double rateWeight, colorsWeight, crfWeight;  ///< relative to the weight of the pixels
};
constexpr Model kGif{0.78, 0.9, 0.27, 0, 3.7, 1.1, 0};
constexpr Model kApng{0.8, 0.9, 0, 0, 3.7, 0, 0};
constexpr Model kCompressed{0.77, 0.43, 0, 0.108, 2.4, 0, 0.028};
constexpr Model kProRes{0.9, 1, 0, 0, 3.7, 0, 0};

const Model& modelOf(FilmContainer container) {
  switch (container) {
    case FilmContainer::kGif:
      return kGif;
    case FilmContainer::kApng:
      return kApng;
    case FilmContainer::kMov:
      return kProRes;
    case FilmContainer::kMp4:
    case FilmContainer::kWebm:
      break;
  }
  return kCompressed;
}

double pixelsOf(const FilmChoice& film) { return static_cast<double>(film.size.width) * film.size.height; }

double logPixels(const FilmChoice& from, const FilmChoice& to) { return std::log(pixelsOf(from) / pixelsOf(to)); }

std::vector<image::PixelSize> sizes(image::PixelSize asked) {
  std::vector<image::PixelSize> all{asked};
  for (int width = (asked.width - 1) / kWidthStep * kWidthStep; width >= kLeastWidth; width -= kWidthStep) {
    const int height = 2 * static_cast<int>(std::lround(0.5 * width * asked.height / asked.width));
    if (height >= scene::kLeastSide) all.push_back({width, height});
  }
  return all;
}

core::Rational dividedBy(const core::Rational& rate, std::int64_t n) {
  const std::int64_t common = std::gcd(rate.num, n);
  return {rate.num / common, rate.den * (n / common)};
}

std::vector<core::Rational> rates(const core::Rational& asked, FilmContainer container) {
  std::vector<core::Rational> all{asked};
  if (container == FilmContainer::kGif) {
    for (const core::Rational& rate : kGifRates)
      if (rate.value() < asked.value()) all.push_back(rate);
    return all;
  }
  for (std::int64_t n = 2; asked.value() / static_cast<double>(n) >= kLeastRate; ++n)
    all.push_back(dividedBy(asked, n));
  return all;
}

std::vector<int> palettes(int asked) {
  std::vector<int> all{asked};
  for (const int colors : kPalettes)
    if (colors < asked) all.push_back(colors);
  return all;
}

std::vector<int> rateFactors(int asked) {
  std::vector<int> all{asked};
  for (int crf = asked + kCrfStep; crf <= kWorstCrf; crf += kCrfStep) all.push_back(crf);
  return all;
}

template <class T>
void keepAsked(std::vector<T>& values, bool isFixed) {
  if (isFixed) values.resize(1);
}

}  // namespace

std::vector<FilmChoice> smallerFilms(const FilmChoice& asked, FilmContainer container,
                                     const FixedProperties& fixed) {
  const Model& model = modelOf(container);
  auto allSizes = sizes(asked.size);
  auto allRates = rates(asked.fps, container);
  auto allPalettes = palettes(asked.colors);
  auto allFactors = rateFactors(asked.crf);
  keepAsked(allSizes, fixed.size);
  keepAsked(allRates, fixed.fps);
  keepAsked(allPalettes, fixed.colors || model.colors == 0);
  keepAsked(allFactors, fixed.crf || model.crf == 0);
  std::vector<FilmChoice> films;
  for (const image::PixelSize& size : allSizes)
    for (const core::Rational& fps : allRates)
      for (const int colors : allPalettes)
        for (const int crf : allFactors) films.push_back({size, fps, colors, crf});
  return films;
}

SizeSearch::SizeSearch(const FilmChoice& asked, FilmContainer container, const FixedProperties& fixed,
                       std::int64_t most_bytes)
    : most_bytes_(most_bytes) {
  POINSOT_EXPECT(most_bytes > 0);
  const Model& m = modelOf(container);
  for (const FilmChoice& film : smallerFilms(asked, container, fixed)) {
    const double pixels = logPixels(asked, film);
    const double rate = std::log(asked.fps.value() / film.fps.value());
    const double colors = std::log(static_cast<double>(asked.colors) / film.colors);
    const double crf = film.crf - asked.crf;
    candidates_.push_back({film, m.pixels * pixels + m.rate * rate + m.colors * colors + m.crf * crf,
                           pixels * pixels + m.rateWeight * rate * rate + m.colorsWeight * colors * colors +
                               m.crfWeight * crf * crf});
  }
}

std::optional<SizeTrial> SizeSearch::next() const {
  if (measured_.empty()) {
    const std::size_t first = probe();
    return first == 0 ? trial(first) : SizeTrial{candidates_[first].film, {1, 0}};
  }
  if (measured_.size() > kMostTrials) return std::nullopt;
  const bool isSecond = measured_.size() == 1;
  if (measured_.size() < kMostTrials) {
    if (mayFitAsAsked()) return trial(0);
    if (const auto best = bestPredicted())
      return trial(*best, isSecond ? kGoodShare * static_cast<double>(most_bytes_) : 0);
  }
  if (const Measured* best = bestThatFits()) return trial(best->candidate);
  const std::size_t last = leastBytes();
  return isMeasured(last) ? std::nullopt : std::optional(trial(last));
}

void SizeSearch::add(std::int64_t bytes) {
  const auto made = next();
  POINSOT_EXPECT(made && bytes > 0);
  const auto at = std::ranges::find(candidates_, made->film, &Candidate::film);
  measured_.push_back({static_cast<std::size_t>(at - candidates_.begin()), {made->film, bytes}});
}

const MeasuredFilm& SizeSearch::smallest() const {
  POINSOT_EXPECT(!measured_.empty());
  return std::ranges::min_element(measured_, {}, [](const Measured& m) { return m.film.bytes; })->film;
}

SizeTrial SizeSearch::trial(std::size_t candidate, double least_bytes) const {
  return {candidates_[candidate].film, {static_cast<std::int64_t>(least_bytes), most_bytes_}};
}

/// Returns a film that differs from the film as asked only in its size, and is made in a fraction of the time.
/// Returns the film as asked if that is small itself.
std::size_t SizeSearch::probe() const {
  const FilmChoice& asked = candidates_.front().film;
  if (pixelsOf(asked) <= 2.0 * kProbePixels) return 0;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const FilmChoice& film = candidates_[i].film;
    const bool onlySmaller = film.fps == asked.fps && film.colors == asked.colors && film.crf == asked.crf;
    if (onlySmaller && pixelsOf(film) <= kProbePixels) return i;
  }
  return 0;
}

bool SizeSearch::mayFitAsAsked() const {
  const FilmChoice& asked = candidates_.front().film;
  return std::ranges::all_of(measured_, [&](const Measured& m) {
    const double least_bytes =
        static_cast<double>(m.film.bytes) * std::exp(kLeastPixelPower * logPixels(asked, m.film.film));
    return m.candidate != 0 && least_bytes <= static_cast<double>(most_bytes_);
  });
}

/// Returns by which factor the logarithm of the size changes faster than in the model, from the last two films.
double SizeSearch::steepness() const {
  if (measured_.size() < 2) return 1;
  const Measured &a = measured_[measured_.size() - 2], &b = measured_.back();
  const double modelled = candidates_[b.candidate].shrink - candidates_[a.candidate].shrink;
  if (std::abs(modelled) < 0.2) return 1;
  const double found = std::log(static_cast<double>(a.film.bytes) / static_cast<double>(b.film.bytes));
  return std::clamp(found / modelled, 0.6, 1.5);
}

double SizeSearch::predicted_bytes(const Candidate& film) const {
  const auto distance = [&](const Measured& m) { return std::abs(candidates_[m.candidate].shrink - film.shrink); };
  const auto nearest = std::ranges::min_element(measured_, {}, distance);
  const double further = film.shrink - candidates_[nearest->candidate].shrink;
  return static_cast<double>(nearest->film.bytes) * std::exp(-steepness() * further);
}

bool SizeSearch::isMeasured(std::size_t candidate) const {
  return std::ranges::find(measured_, candidate, &Measured::candidate) != measured_.end();
}

const SizeSearch::Measured* SizeSearch::bestThatFits() const {
  const Measured* best = nullptr;
  for (const Measured& m : measured_)
    if (m.film.bytes <= most_bytes_ &&
        (best == nullptr || candidates_[m.candidate].loss < candidates_[best->candidate].loss))
      best = &m;
  return best;
}

/// Returns the best film that should fit and is better than every film that is known to fit.
std::optional<std::size_t> SizeSearch::bestPredicted() const {
  const Measured* fits = bestThatFits();
  const bool careful = fits == nullptr && measured_.size() > 1;
  const double aim_bytes = (careful ? kCarefulAim : kAim) * static_cast<double>(most_bytes_);
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const Candidate& film = candidates_[i];
    if (best && film.loss >= candidates_[*best].loss) continue;
    if (fits != nullptr && film.loss >= candidates_[fits->candidate].loss) continue;
    if (!isMeasured(i) && predicted_bytes(film) <= aim_bytes) best = i;
  }
  return best;
}

std::size_t SizeSearch::leastBytes() const {
  const auto least = std::ranges::max_element(candidates_, {}, &Candidate::shrink);
  return static_cast<std::size_t>(least - candidates_.begin());
}

}  // namespace poinsot::job
