// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/changes.h"
#include "core/text.h"

namespace poinsot::compare {
namespace {

constexpr const char* kChannels[] = {"red", "green", "blue", "alpha"};

int widthOf(const image::PixelRect& box) { return box.right - box.left; }
int heightOf(const image::PixelRect& box) { return box.bottom - box.top; }

std::string pixelsText(std::int64_t pixels) { return fmt::format("{} pixel{}", pixels, pixels == 1 ? "" : "s"); }

std::string boxText(const image::PixelRect& box) {
  return fmt::format("{}x{} px at ({}, {})", widthOf(box), heightOf(box), box.left, box.top);
}

/// Reports whether the box covers at least `share` of both the picture's width and its height.
bool spans(const image::PixelRect& box, image::PixelSize size, double share) {
  return widthOf(box) >= share * size.width && heightOf(box) >= share * size.height;
}

std::string shiftText(const Shift& shift) {
  std::vector<std::string> parts;
  if (shift.x != 0)
    parts.push_back(fmt::format("{} px to the {}", std::abs(shift.x), shift.x > 0 ? "right" : "left"));
  if (shift.y != 0) parts.push_back(fmt::format("{} px {}", std::abs(shift.y), shift.y > 0 ? "down" : "up"));
  return fmt::format("by {}", core::joined(parts, " and "));
}

std::string movedText(const Changes& changes) {
  const std::string by = shiftText(*changes.shift);
  constexpr double kMostOfIt = 0.5;
  if (spans(changes.box, changes.size, kMostOfIt)) return "the picture moved " + by;
  if (changes.placeCount == 1) return fmt::format("one place of {} moved {}", boxText(changes.box), by);
  return fmt::format("{} places in {} moved {}", changes.placeCount, boxText(changes.box), by);
}

std::string levelText(const std::array<double, 4>& level) {
  if (level[0] == level[1] && level[1] == level[2] && level[3] == 0)
    return fmt::format("{} by {:.3g} everywhere", level[0] > 0 ? "brighter" : "darker", std::abs(level[0]));
  std::vector<std::string> parts;
  for (std::size_t c = 0; c < level.size(); ++c)
    if (level[c] != 0)
      parts.push_back(
          fmt::format("{} {} by {:.3g}", kChannels[c], level[c] > 0 ? "higher" : "lower", std::abs(level[c])));
  return fmt::format("{} everywhere", core::joined(parts, ", "));
}

std::string toneText(const ToneChange& tone) {
  switch (tone.kind) {
    case ToneChange::Kind::kLevel:
      return levelText(tone.level);
    case ToneChange::Kind::kGain:
      return fmt::format("values multiplied by {:.3g} everywhere", tone.factor);
    case ToneChange::Kind::kContrast:
      return fmt::format("contrast multiplied by {:.3g} everywhere", tone.factor);
    case ToneChange::Kind::kCurve:
      break;
  }
  return "another tone curve everywhere";
}

std::string symmetryText(Symmetry symmetry) {
  switch (symmetry) {
    case Symmetry::kUpsideDown:
      return "upside down";
    case Symmetry::kMirrored:
      return "mirrored left to right";
    case Symmetry::kRedAndBlueExchanged:
      break;
  }
  return "red and blue are exchanged everywhere";
}

/// Reports whether the changes are many and far apart, and no place has most of the differing pixels.
bool areScattered(const Changes& changes) {
  constexpr std::int64_t kMany = 30;
  return changes.placeCount >= kMany && 4 * changes.places.front().pixels <= changes.pixels &&
         spans(changes.box, changes.size, 0.5);
}

bool areEverywhere(const Changes& changes) {
  const double all = static_cast<double>(changes.size.width) * changes.size.height;
  return spans(changes.places.front().box, changes.size, 0.8) && static_cast<double>(changes.pixels) >= 0.1 * all;
}

std::string placesText(const Changes& changes) {
  const std::string pixels = pixelsText(changes.pixels);
  const ChangedPlace& largest = changes.places.front();
  if (areScattered(changes))
    return fmt::format("{} scattered over {}", pixels,
                       spans(changes.box, changes.size, 0.75) ? "the whole picture" : boxText(changes.box));
  if (areEverywhere(changes)) {
    const double all = static_cast<double>(changes.size.width) * changes.size.height;
    return fmt::format("{} ({:.3g} %) all over the picture", pixels,
                       100 * static_cast<double>(changes.pixels) / all);
  }
  if (changes.pixels == 1) return fmt::format("1 pixel at ({}, {})", largest.box.left, largest.box.top);
  if (changes.placeCount == 1) return fmt::format("{} in one place of {}", pixels, boxText(largest.box));
  return fmt::format("{} in {} places, the largest of {}{}", pixels, changes.placeCount, boxText(largest.box),
                     changes.shiftOfLargest ? ", which moved " + shiftText(*changes.shiftOfLargest) : "");
}

/// Returns text such as ", only in green" if exactly one channel differs, otherwise an empty string.
std::string channelText(const Changes& changes) {
  if (std::ranges::count(changes.channels, true) != 1) return "";
  const auto place = std::ranges::find(changes.channels, true) - changes.channels.begin();
  return fmt::format(", only in {}", kChannels[place]);
}

/// Reports whether the difference is too small to see. If so, the text states its size instead of the colours.
bool isHardlySeen(const Changes& changes) { return changes.largest <= 4; }

std::string sizeText(const Changes& changes) {
  return isHardlySeen(changes) ? fmt::format(", by at most {:.3g} of 255", changes.largest) : "";
}

std::string colourText(const Changes& changes) {
  if (!changes.recolouring || changes.shiftOfLargest || isHardlySeen(changes)) return "";
  const auto& [from, to, pixels] = *changes.recolouring;
  return fmt::format(", {} became {}{}", from, to,
                     pixels < changes.pixels ? fmt::format(" in {} of them", pixels) : "");
}

/// Returns the kind of changes that no tone, symmetry or shift explains.
std::string kindOfPlaces(const Changes& changes) {
  if (isHardlySeen(changes)) return "hardly visible";
  if (changes.recolouring && !changes.shiftOfLargest)
    return fmt::format("{} became {}", changes.recolouring->from, changes.recolouring->to);
  if (areScattered(changes)) return "scattered";
  if (areEverywhere(changes)) return "all over the picture";
  return "in some places";
}

}  // namespace

std::string kindOf(const Changes& changes) {
  if (changes.pixels == 0) return "";
  if (changes.tone) return toneText(*changes.tone);
  if (changes.symmetry) return symmetryText(*changes.symmetry);
  if (changes.shift) return "moved " + shiftText(*changes.shift);
  return kindOfPlaces(changes);
}

std::string wordsOf(const Changes& changes) {
  if (changes.pixels == 0) return "";
  if (changes.tone) return toneText(*changes.tone);
  if (changes.symmetry) return symmetryText(*changes.symmetry);
  if (changes.shift) return movedText(changes);
  return placesText(changes) + colourText(changes) + channelText(changes) + sizeText(changes);
}

}  // namespace poinsot::compare
