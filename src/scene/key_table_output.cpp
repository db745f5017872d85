// SPDX-License-Identifier: Apache-2.0
#include "scene/key_tables.h"
#include "scene/limits.h"
#include "scene/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

std::vector<std::string_view> qualityWords() {
  std::vector<std::string_view> words;
  for (const QualityPreset& preset : qualityPresets()) words.push_back(preset.name);
  return words;
}

}  // namespace

std::vector<Key> outputKeys() {
  return {
      {.path = "output.quality",
       .type = kWord,
       .words = qualityWords(),
       .fallback = "\"1080p\"",
       .example = "\"preview\"",
       .help = "Sets size and crf together; either, given besides, wins.",
       .put = into([](Draft& d) { return &d.quality; })},
      {.path = "output.size",
       .type = kPixels,
       .range = {.least = kLeastSide, .most = kMostSide},
       .example = "[1280, 720]",
       .help = "Width and height of the picture in pixels, both even; 64 million pixels at most.",
       .put = into([](Draft& d) { return &d.size_px; })},
      {.path = "output.crf",
       .type = kInteger,
       .range = {.least = 0, .most = 51},
       .example = "20",
       .help = "Constant rate factor of the film: 0 is lossless, 18 shows no loss, 51 is worst.",
       .put = into([](Draft& d) { return &d.crf; })},
  };
}

}  // namespace poinsot::scene
