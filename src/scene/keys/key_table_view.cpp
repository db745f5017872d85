// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;

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
       .help = "Heading of the panel, written like show.title.",
       .isTex = true,
       .put = intoView([](ViewDraft& v) { return &v.title; })},
      {.path = "view[].subtitle",
       .type = kText,
       .range = {.least = 0, .most = 200},
       .example = "'$\\mathbf{L}$ stands still'",
       .help = "One line under the panel's heading.",
       .isTex = true,
       .put = intoView([](ViewDraft& v) { return &v.subtitle; })},
      cellKey("view[].at", kCellNumber, "[1, 0]",
              "Column and row of the panel's top left cell. Both are counted from 0 at the picture's top left. By "
              "default, the panel is to the right of the panel before.",
              intoView([](ViewDraft& v) { return &v.at; })),
      cellKey("view[].span", kCellCount, "[2, 1]",
              "Number of columns and rows that the panel takes. The default is one column and one row.",
              intoView([](ViewDraft& v) { return &v.span; })),
  };
}

/// Returns the key of a view that corresponds to a key of [camera] or [show]. The key of the view has no default,
/// because the scene's value is used.
Key ofView(Key key) {
  key.path = "view[]." + key.path;
  key.fallback = {};
  key.put = [put = key.put](Draft& d, std::size_t i, const Checked& value) {
    elementAt(d.views, i).given.push_back([put, value](Draft& view) { put(view, 0, value); });
  };
  return key;
}

}  // namespace

Key cellKey(std::string path, Range range, std::string_view example, std::string_view help, Put put) {
  return {.path = std::move(path),
          .type = kCell,
          .range = range,
          .example = example,
          .help = help,
          .put = std::move(put)};
}

std::vector<Key> viewKeys() {
  std::vector<Key> keys = panelKeys();
  for (Key& key : joined({cameraKeys(), shownKeys()})) keys.push_back(ofView(std::move(key)));
  return keys;
}

}  // namespace poinsot::scene
