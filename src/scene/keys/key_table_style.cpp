// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

constexpr Range kFactor{.least = 0.1, .most = 10};

std::vector<Key> keysOfColors() {
  std::vector<Key> keys;
  for (std::size_t i = 0; i < kColorMeanings; ++i) {
    const ColorKey& meaning = colorKeys()[i];
    keys.push_back({.path = "style.colors." + std::string(meaning.name),
                    .type = kColor,
                    .example = meaning.example,
                    .help = meaning.help,
                    .put = into([i](Draft& d) { return &d.scene.style.colors[i]; })});
  }
  return keys;
}

std::vector<Key> formKeys() {
  return {
      {.path = "style.file",
       .type = kText,
       .range = kPathLength,
       .example = "\"house.style.toml\"",
       .help = "Style file, which contains a [style] table. The file must be in the scene's folder or below it. "
               "Keys in the scene override the same keys in this file.",
       .put = [](Draft&, std::size_t, const Checked&) {}},  // stores nothing: addStyleFile() runs before put
      {.path = "style.theme",
       .type = kWord,
       .words = {"light", "dark", "print"},
       .fallback = "\"light\"",
       .example = "\"dark\"",
       .help = "Theme that sets the colours and lines of the picture. `light` has a white background. `dark` is "
               "for slides in a dark room. `print` has thin lines in black, greys and one colour, and is still "
               "readable after photocopying.",
       .put = into([](Draft& d) { return &d.scene.style.theme; })},
      {.path = "style.preset",
       .type = kWord,
       .words = {"screen", "hall"},
       .fallback = "\"screen\"",
       .example = "\"hall\"",
       .help =
           "Sizes of text and lines. `hall` is for the last row of a lecture hall: no text is smaller than 3.3 % "
           "of the picture's height, and lines are thicker. `style = \"hall\"` is short for this key, if the "
           "scene has no other key of [style].",
       .put = into([](Draft& d) { return &d.scene.style.preset; })},
      {.path = "style.line_width",
       .range = kFactor,
       .fallback = "1",
       .example = "1.5",
       .help = "Factor on the widths of all lines in the theme.",
       .put = into([](Draft& d) { return &d.scene.style.lineWidth; })},
      {.path = "style.text_size",
       .range = kFactor,
       .fallback = "1",
       .example = "1.25",
       .help = "Factor on the size of all text.",
       .put = into([](Draft& d) { return &d.scene.style.textSize; })},
      {.path = "style.decimal_sign",
       .type = kWord,
       .words = {"point", "comma"},
       .fallback = "\"point\"",
       .example = "\"comma\"",
       .help = "Decimal sign of every number that is drawn: 1.5 or 1,5.",
       .put = into([](Draft& d) { return &d.scene.style.decimalSign; })},
  };
}

}  // namespace

std::vector<Key> styleKeys() { return joined({formKeys(), keysOfColors()}); }

}  // namespace poinsot::scene
