// SPDX-License-Identifier: Apache-2.0
#include "scene/key_tables.h"
#include "scene/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;

// More panels than 8 x 8 are too small to be looked at.
constexpr Range kCellNumber{.least = 0, .most = 7};
constexpr Range kCellCount{.least = 1, .most = 8};

template <class F>
Put intoView(F place) {
  return into([place](Draft& d, std::size_t i) { return place(elementAt(d.views, i)); });
}

std::vector<Key> panelKeys() {
  return {
      {.path = "view[].title",
       .type = kText,
       .range = {.least = 0, .most = 200},
       .example = "\"In space\"",
       .help = "Heading of the panel, as show.title is of the picture.",
       .put = intoView([](ViewDraft& v) { return &v.title; })},
      {.path = "view[].subtitle",
       .type = kText,
       .range = {.least = 0, .most = 200},
       .example = "'$\\mathbf{L}$ stands still'",
       .help = "One line under the panel's heading.",
       .put = intoView([](ViewDraft& v) { return &v.subtitle; })},
      {.path = "view[].at",
       .type = kCell,
       .range = kCellNumber,
       .example = "[1, 0]",
       .help = "Column and row of the panel's top left cell, from 0 at the picture's top left; without it, to the "
               "right of the view before.",
       .put = intoView([](ViewDraft& v) { return &v.at; })},
      {.path = "view[].span",
       .type = kCell,
       .range = kCellCount,
       .example = "[2, 1]",
       .help = "Columns and rows that the panel takes; without it, one cell.",
       .put = intoView([](ViewDraft& v) { return &v.span; })},
  };
}

/// A key of [camera] or [show] as one of a view's own, without which the scene's counts.
Key ofView(Key key) {
  key.path = "view[]." + key.path;
  key.fallback = {};
  key.put = [put = key.put](Draft& d, std::size_t i, const Checked& value) {
    elementAt(d.views, i).given.push_back([put, value](Draft& view) { put(view, 0, value); });
  };
  return key;
}

}  // namespace

std::vector<Key> viewKeys() {
  std::vector<Key> keys = panelKeys();
  for (Key& key : joined({cameraKeys(), shownKeys()})) keys.push_back(ofView(std::move(key)));
  return keys;
}

}  // namespace poinsot::scene
