// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"
#include "scene/limits.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

std::vector<std::string_view> qualityWords() {
  std::vector<std::string_view> words;
  for (const QualityPreset& preset : qualityPresets()) words.push_back(preset.name);
  return words;
}

std::vector<std::string_view> listOf(std::span<const std::string_view> words) {
  return {words.begin(), words.end()};
}

}  // namespace

std::vector<Key> outputKeys() {
  return {
      {.path = "output.quality",
       .type = kWord,
       .words = qualityWords(),
       .fallback = "\"1080p\"",
       .example = "\"preview\"",
       .help = "Preset of `size` and `crf`. An explicit `size` or `crf` overrides the preset.",
       .put = into([](Draft& d) { return &d.quality; })},
      {.path = "output.size",
       .type = kPixels,
       .range = {.least = kLeastSide, .most = usual(Limit::kSide), .limit = Limit::kSide},
       .example = "[1280, 720]",
       .help = "Width and height of the picture in pixels, both even.",
       .put = into([](Draft& d) { return &d.size_px; })},
      {.path = "output.crf",
       .type = kInteger,
       .range = {.least = 0, .most = 51},
       .example = "20",
       .help = "Constant rate factor of the film: 0 is lossless, 18 shows no loss, 51 is worst.",
       .put = into([](Draft& d) { return &d.crf; })},
      {.path = "output.codec",
       .type = kWord,
       .words = listOf(codecWords()),
       .example = "\"hevc\"",
       .help = "Codec of the film. By default, the usual codec of the file's type. .mp4 holds h264 and hevc, "
               ".webm holds vp9 and av1, .mov holds prores.",
       .put = into([](Draft& d) { return &d.codec; })},
      {.path = "output.chroma",
       .type = kWord,
       .words = listOf(chromaWords()),
       .fallback = "\"4:2:0\"",
       .example = "\"4:4:4\"",
       .help = "Colour resolution of the film. 4:2:0 stores one colour for each square of four pixels, which "
               "every player shows. 4:4:4 stores a colour for each pixel.",
       .put = into([](Draft& d) { return &d.chroma; })},
      {.path = "output.effort",
       .type = kWord,
       .words = listOf(effortWords()),
       .fallback = "\"medium\"",
       .example = "\"slow\"",
       .help = "Time that the encoder spends on a smaller file of the same quality.",
       .put = into([](Draft& d) { return &d.effort; })},
  };
}

}  // namespace poinsot::scene
