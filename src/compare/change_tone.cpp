// SPDX-License-Identifier: Apache-2.0
#include "compare/change_measures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/expect.h"

namespace poinsot::compare {
namespace {

constexpr int kNone = -1;

/// New value for each old value of a channel, or kNone if no pixel has the old value.
using Table = std::vector<int>;

struct Entry {
  int channel, from, to;
};

/// New values of all old values that occur in the reference, sorted by channel and old value.
struct Mapping {
  std::vector<Entry> entries;
  int most = 0;             ///< largest value of a sample
  bool allChanged = false;  ///< whether every compared pixel changed

  bool isCut(const Entry& entry) const { return entry.to == 0 || entry.to == most; }
};

template <typename Sample>
std::vector<Entry> entriesOf(const std::vector<Table>& tables) {
  std::vector<Entry> entries;
  for (std::size_t channel = 0; channel < tables.size(); ++channel)
    for (std::size_t from = 0; from < tables[channel].size(); ++from)
      if (tables[channel][from] != kNone)
        entries.push_back({static_cast<int>(channel), static_cast<int>(from), tables[channel][from]});
  return entries;
}

/// Returns the new value of each old value. Returns nullopt if one old value has two new values.
template <typename Sample>
std::optional<Mapping> mappingOf(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b,
                                 const IgnoreMask* ignored) {
  const auto channels = static_cast<std::size_t>(a.channels);
  std::vector<Table> tables(channels, Table(std::size_t{image::BasicImage<Sample>::kMost} + 1, kNone));
  bool allChanged = true;
  for (std::size_t i = 0; i < a.pixels.size(); i += channels) {
    if (ignored && ignored->ignoresPixel(i / channels)) continue;
    bool changed = false;
    for (std::size_t c = 0; c < channels; ++c) {
      int& to = tables[c][a.pixels[i + c]];
      const int now = b.pixels[i + c];
      if (to == kNone) to = now;
      if (to != now) return std::nullopt;
      changed = changed || now != a.pixels[i + c];
    }
    allChanged = allChanged && changed;
  }
  return Mapping{entriesOf<Sample>(tables), image::BasicImage<Sample>::kMost, allChanged};
}

/// Returns the number of values that changed without being clipped. A single recoloured area has only one such
/// value in each channel.
std::ptrdiff_t evidence(const Mapping& mapping) {
  return std::ranges::count_if(mapping.entries,
                               [&](const Entry& e) { return e.to != e.from && !mapping.isCut(e); });
}

std::optional<ToneChange> levelOf(const Mapping& mapping) {
  std::array<int, 4> level{};
  for (const Entry& e : mapping.entries)
    if (!mapping.isCut(e)) level[static_cast<std::size_t>(e.channel)] = e.to - e.from;
  const bool holds = std::ranges::all_of(mapping.entries, [&](const Entry& e) {
    return e.to == std::clamp(e.from + level[static_cast<std::size_t>(e.channel)], 0, mapping.most);
  });
  const auto changed = std::ranges::count_if(level, [](int l) { return l != 0; });
  if (!holds || changed == 0) return std::nullopt;
  const bool isOneColour = evidence(mapping) <= changed;
  const bool isGrey = level[0] == level[1] && level[1] == level[2];
  if (isOneColour && !(mapping.allChanged && isGrey)) return std::nullopt;
  ToneChange change;
  std::ranges::transform(level, change.level.begin(), [&](int l) { return l * 255.0 / mapping.most; });
  return change;
}

/// Returns a change that multiplies the distance of each value from `centre` by one factor, exact to 1/255.
/// Returns nullopt if no factor fits, or if alpha changed.
std::optional<ToneChange> scaledFrom(double centre, ToneChange::Kind kind, const Mapping& mapping) {
  double products = 0, squares = 0;
  for (const Entry& e : mapping.entries) {
    if (e.channel == 3 || mapping.isCut(e)) continue;
    products += (e.from - centre) * (e.to - centre);
    squares += (e.from - centre) * (e.from - centre);
  }
  const double factor = squares > 0 ? products / squares : 0;
  const bool holds = factor > 0 && std::ranges::all_of(mapping.entries, [&](const Entry& e) {
                       if (e.channel == 3) return e.to == e.from;
                       const double expected =
                           std::clamp(centre + factor * (e.from - centre), 0.0, double(mapping.most));
                       return std::abs(e.to - expected) <= mapping.most / 255.0;
                     });
  return holds ? std::optional(ToneChange{kind, {}, factor}) : std::nullopt;
}

/// Reports whether new values rise with old values, and most new values differ from one another. If an object was
/// recoloured or removed instead, many old values become one new value.
bool isCurve(const Mapping& mapping) {
  std::size_t rises = 0;
  for (std::size_t i = 1; i < mapping.entries.size(); ++i) {
    const Entry &before = mapping.entries[i - 1], &here = mapping.entries[i];
    if (here.channel != before.channel) continue;
    if (here.to < before.to) return false;
    rises += here.to > before.to ? 1 : 0;
  }
  return 2 * rises >= mapping.entries.size();
}

std::optional<ToneChange> changeOf(const Mapping& mapping) {
  if (const auto level = levelOf(mapping)) return level;
  constexpr std::ptrdiff_t kFewest = 8;
  if (evidence(mapping) < kFewest) return std::nullopt;
  if (const auto gain = scaledFrom(0, ToneChange::Kind::kGain, mapping)) return gain;
  if (const auto contrast = scaledFrom(mapping.most / 2.0, ToneChange::Kind::kContrast, mapping)) return contrast;
  return isCurve(mapping) ? std::optional(ToneChange{ToneChange::Kind::kCurve, {}, 1}) : std::nullopt;
}

template <typename Sample>
std::optional<ToneChange> found(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b,
                                const IgnoreMask* ignored) {
  POINSOT_EXPECT(a.size == b.size && a.channels == b.channels);
  const auto mapping = mappingOf(a, b, ignored);
  return mapping ? changeOf(*mapping) : std::nullopt;
}

}  // namespace

std::optional<ToneChange> toneChange(const image::Image& reference, const image::Image& test,
                                     const IgnoreMask* ignored) {
  return found(reference, test, ignored);
}

std::optional<ToneChange> toneChange(const image::DeepImage& reference, const image::DeepImage& test,
                                     const IgnoreMask* ignored) {
  return found(reference, test, ignored);
}

}  // namespace poinsot::compare
