// SPDX-License-Identifier: Apache-2.0
#include "scene/key_tables.h"
#include "scene/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

constexpr Range kFactor{.least = 0.1, .most = 10};

}  // namespace

std::vector<Key> styleKeys() {
  return {
      {.path = "style.theme",
       .type = kWord,
       .words = {"light", "dark"},
       .fallback = "\"light\"",
       .example = "\"dark\"",
       .help = "White ground for print, dark for slides.",
       .put = into([](Draft& d) { return &d.scene.style.theme; })},
      {.path = "style.line_width",
       .range = kFactor,
       .fallback = "1",
       .example = "1.5",
       .help = "Factor on the width of all lines.",
       .put = into([](Draft& d) { return &d.scene.style.lineWidth; })},
      {.path = "style.text_size",
       .range = kFactor,
       .fallback = "1",
       .example = "1.25",
       .help = "Factor on the size of all type.",
       .put = into([](Draft& d) { return &d.scene.style.textSize; })},
      {.path = "style.decimal_sign",
       .type = kWord,
       .words = {"point", "comma"},
       .fallback = "\"point\"",
       .example = "\"comma\"",
       .help = "What stands before the decimals of every number that is drawn: 1.5 or 1,5.",
       .put = into([](Draft& d) { return &d.scene.style.decimalSign; })},
  };
}

}  // namespace poinsot::scene
