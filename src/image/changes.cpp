// SPDX-License-Identifier: Apache-2.0
#include "image/changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/expect.h"
#include "image/changed_pixels.h"

namespace poinsot::image {
namespace {

/// The samples of a pixel, each in 16 bits of one number.
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

/// Finds what more than half of all values are, if any value is: the majority vote of Boyer and Moore (1981).
template <typename Value>
class Majority {
 public:
  void add(const Value& value) {
    if (votes_ == 0) value_ = value;
    votes_ += value == value_ ? 1 : -1;
  }
  /// Returns the only value that may be the majority. Count it to be sure.
  const Value& candidate() const { return value_; }

 private:
  Value value_{};
  std::int64_t votes_ = 0;
};

template <typename Sample>
class Finder {
 public:
  Finder(const BasicImage<Sample>& a, const BasicImage<Sample>& b) : a_(a), b_(b), places_(a.size) {
    changes_.size = a.size;
  }

  Changes changes() {
    forEachChangedPixel(a_, b_, wholeOf(a_.size),
                        [&](int x, int y, const Sample* p, const Sample* q) { add(x, y, p, q); });
    if (changes_.pixels == 0) return changes_;
    changes_.largest = largest_ * 255.0 / BasicImage<Sample>::kMost;
    addPlaces();
    addRecolouring();
    changes_.tone = toneChange(a_, b_);
    if (!changes_.tone) addShifts();
    return std::move(changes_);
  }

 private:
  using Pair = std::pair<std::uint64_t, std::uint64_t>;  // colours in the reference and in the test

  void add(int x, int y, const Sample* p, const Sample* q) {
    ++changes_.pixels;
    places_.add(x, y);
    pair_.add(pairOf(p, q));
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
    const Pair& pair = pair_.candidate();
    std::int64_t count = 0;
    forEachChangedPixel(a_, b_, changes_.box, [&](int, int, const Sample* p, const Sample* q) {
      count += pairOf(p, q) == pair ? 1 : 0;
    });
    if (2 * count > changes_.pixels)
      changes_.recolouring = {colourText<Sample>(pair.first, a_.channels),
                              colourText<Sample>(pair.second, a_.channels), count};
  }

  void addShifts() {
    changes_.shift = shiftOf(a_, b_, changes_.box, changes_.pixels);
    const ChangedPlace& largest = changes_.places.front();
    if (!changes_.shift && changes_.placeCount > 1)
      changes_.shiftOfLargest = shiftOf(a_, b_, largest.box, largest.pixels);
  }

  const BasicImage<Sample>&a_, &b_;
  Changes changes_;
  PlaceFinder places_;
  Majority<Pair> pair_;
  int largest_ = 0;  // in the samples' own steps
};

}  // namespace

Changes changesBetween(const AnyImage& reference, const AnyImage& test) {
  const auto *a = std::get_if<Image>(&reference), *b = std::get_if<Image>(&test);
  if (a && b) {
    POINSOT_EXPECT(a->size == b->size && a->channels == b->channels);
    return Finder(*a, *b).changes();
  }
  const DeepImage deepA = deepened(reference), deepB = deepened(test);
  POINSOT_EXPECT(deepA.size == deepB.size && deepA.channels == deepB.channels);
  return Finder(deepA, deepB).changes();
}

}  // namespace poinsot::image
