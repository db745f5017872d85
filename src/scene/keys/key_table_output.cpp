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
       .help = "Preset that sets both `size` and `crf`. If the scene also gives `size` or `crf`, that value "
               "overrides the preset.",
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
       .help = "Constant rate factor of the film, which sets its quality. 0 is lossless, 18 shows no loss to the "
               "eye, and 51 is the worst quality.",
       .put = into([](Draft& d) { return &d.crf; })},
      {.path = "output.codec",
       .type = kWord,
       .words = listOf(codecWords()),
       .example = "\"hevc\"",
       .help = "Codec of the film. The default is the usual codec of the film's file type. A .mp4 file holds h264 "
               "or hevc, a .webm file holds vp9 or av1, and a .mov file holds prores.",
       .put = into([](Draft& d) { return &d.codec; })},
      {.path = "output.chroma",
       .type = kWord,
       .words = listOf(chromaWords()),
       .fallback = "\"4:2:0\"",
       .example = "\"4:4:4\"",
       .help = "Colour resolution of the film. 4:2:0 stores one colour for each square of four pixels, and every "
               "player can show it. 4:4:4 stores a colour for each pixel.",
       .put = into([](Draft& d) { return &d.chroma; })},
      {.path = "output.effort",
       .type = kWord,
       .words = listOf(effortWords()),
       .fallback = "\"medium\"",
       .example = "\"slow\"",
       .help = "Amount of time that the encoder spends to make the film's file smaller at the same quality.",
       .put = into([](Draft& d) { return &d.effort; })},
      {.path = "output.colors",
       .type = kInteger,
       .range = {.least = 2, .most = 255},
       .fallback = "255",
       .example = "64",
       .help =
           "Number of colours in the palette of a GIF. With fewer colours, the file is smaller and gradients are "
           "coarser. Other formats ignore this key.",
       .put = into([](Draft& d) { return &d.scene.output.colors; })},
      {.path = "output.language",
       .type = kWord,
       .words = {"en", "de"},
       .fallback = "\"en\"",
       .example = "\"de\"",
       .help =
           "Language of the description that `info --alt` prints and that picture files contain, for readers who "
           "do not see the picture: English or German. Titles and captions are not translated.",
       .put = into([](Draft& d) { return &d.scene.output.language; })},
  };
}

}  // namespace poinsot::scene
