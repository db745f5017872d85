// SPDX-License-Identifier: Apache-2.0
#include "compare/changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

#include "compare/changed_pixels.h"
#include "core/expect.h"

namespace poinsot::compare {
namespace {

template <typename Sample>
std::uint64_t packed(const Sample* samples, int channels) {
  std::uint64_t colour = 0;
  for (int c = 0; c < 3; ++c) colour = colour << 16 | samples[c];
  return channels == 4 ? colour << 16 | samples[3] : colour;
}

template <typename Sample>
std::string colourText(std::uint64_t colour, int channels) {
  std::string text = "#";
  for (int c = channels - 1; c >= 0; --c)
    text += fmt::format("{:0{}x}", (colour >> (16 * c)) & 0xffff, 2 * sizeof(Sample));
  return text;
}

/// Finds the values that may make up more than a fifth of all added values. Uses the algorithm of Misra and Gries
/// (1982) with four counters.
template <typename Value>
class FrequentValues {
 public:
  void add(const Value& value) {
    Counter* free = nullptr;
    for (Counter& counter : counters_) {
      if (counter.votes > 0 && counter.value == value) {
        ++counter.votes;
        return;
      }
      if (counter.votes == 0) free = &counter;
    }
    if (free)
      *free = {value, 1};
    else
      for (Counter& counter : counters_) --counter.votes;
  }
  /// Returns at most four values, including all that make up more than a fifth. The caller must count them.
  std::vector<Value> candidates() const {
    std::vector<Value> values;
    for (const Counter& counter : counters_)
      if (counter.votes > 0) values.push_back(counter.value);
    return values;
  }

 private:
  struct Counter {
    Value value{};
    std::int64_t votes = 0;
  };
  std::array<Counter, 4> counters_{};
};

template <typename Sample>
class Finder {
 public:
  Finder(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b, const IgnoreMask* ignored)
      : a_(a), b_(b), ignored_(ignored), places_(a.size) {
    changes_.size = a.size;
  }

  Changes changes() {
    forEachChangedPixel(a_, b_, image::wholeOf(a_.size), [&](int x, int y, const Sample* p, const Sample* q) {
      if (!ignored_ || !ignored_->ignores(x, y)) add(x, y, p, q);
    });
    if (changes_.pixels == 0) return changes_;
    changes_.largest = largest_ * 255.0 / image::BasicImage<Sample>::kMost;
    addPlaces();
    addRecolouring();
    changes_.tone = toneChange(a_, b_, ignored_);
    if (!changes_.tone) changes_.symmetry = symmetryOf(a_, b_);
    if (!changes_.tone && !changes_.symmetry) addShifts();
    return std::move(changes_);
  }

 private:
  using Pair = std::pair<std::uint64_t, std::uint64_t>;  // colours in the reference and in the test

  void add(int x, int y, const Sample* p, const Sample* q) {
    ++changes_.pixels;
    places_.add(x, y);
    pairs_.add(pairOf(p, q));
    for (int c = 0; c < a_.channels; ++c) {
      const int difference = std::abs(p[c] - q[c]);
      largest_ = std::max(largest_, difference);
      if (difference > 0) changes_.channels[static_cast<std::size_t>(c)] = true;
    }
  }

  Pair pairOf(const Sample* p, const Sample* q) const { return {packed(p, a_.channels), packed(q, a_.channels)}; }

  void addPlaces() {
    changes_.places = places_.places();
    changes_.placeCount = static_cast<std::int64_t>(changes_.places.size());
    changes_.box = changes_.places.front().box;
    for (const auto& [box, pixels] : changes_.places)
      changes_.box = {std::min(changes_.box.left, box.left), std::min(changes_.box.top, box.top),
                      std::max(changes_.box.right, box.right), std::max(changes_.box.bottom, box.bottom)};
    if (changes_.places.size() > Changes::kMostPlaces) changes_.places.resize(Changes::kMostPlaces);
  }

  void addRecolouring() {
    std::map<Pair, std::int64_t> counts;
    for (const Pair& pair : pairs_.candidates()) counts[pair] = 0;
    forEachChangedPixel(a_, b_, changes_.box, [&](int, int, const Sample* p, const Sample* q) {
      if (const auto found = counts.find(pairOf(p, q)); found != counts.end()) ++found->second;
    });
    const auto most = std::ranges::max_element(counts, {}, [](const auto& count) { return count.second; });
    if (most == counts.end() || 5 * most->second <= changes_.pixels) return;
    // If the opposite change is frequent too, an object moved and was not recoloured.
    const auto back = counts.find({most->first.second, most->first.first});
    if (back != counts.end() && 2 * back->second > most->second) return;
    changes_.recolouring = {colourText<Sample>(most->first.first, a_.channels),
                            colourText<Sample>(most->first.second, a_.channels), most->second};
  }

  void addShifts() {
    changes_.shift = shiftOf(a_, b_, changes_.box, changes_.pixels);
    const ChangedPlace& largest = changes_.places.front();
    if (!changes_.shift && changes_.placeCount > 1)
      changes_.shiftOfLargest = shiftOf(a_, b_, largest.box, largest.pixels);
  }

  const image::BasicImage<Sample>&a_, &b_;
  const IgnoreMask* ignored_;
  Changes changes_;
  PlaceFinder places_;
  FrequentValues<Pair> pairs_;
  int largest_ = 0;  // largest difference, in steps of the sample type
};

}  // namespace

Changes changesBetween(const image::AnyImage& reference, const image::AnyImage& test, const IgnoreMask* ignored) {
  const auto *a = std::get_if<image::Image>(&reference), *b = std::get_if<image::Image>(&test);
  if (a && b) {
    POINSOT_EXPECT(a->size == b->size && a->channels == b->channels);
    return Finder(*a, *b, ignored).changes();
  }
  const image::DeepImage deepA = image::deepened(reference), deepB = image::deepened(test);
  POINSOT_EXPECT(deepA.size == deepB.size && deepA.channels == deepB.channels);
  return Finder(deepA, deepB, ignored).changes();
}

}  // namespace poinsot::compare
