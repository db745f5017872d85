// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace poinsot::scene {

struct Explanation {
  struct Row {
    std::string name, text;
  };

  std::string title;      ///< "camera.fov", "[camera]"
  std::string help;       ///< empty for a table
  std::vector<Row> rows;  ///< for a key: values, units, default, example; for a table: its keys
};

/// Explains a key by its path ("camera.fov", "body.part[3].mass"), a table ("camera", "[[body.part]]"), all keys
/// with a name ("fov"), a shape, a body of the catalogue, a quantity or a unit. "" lists all tables.
/// @param otherWords  words explained elsewhere, which may be suggested, too
/// @throws core::Error(kUsage) for an unknown word, suggesting the nearest one.
std::vector<Explanation> explain(std::string_view word, const std::vector<std::string>& otherWords = {});

/// Returns the same as explain(), but empty for an unknown word.
std::vector<Explanation> explanationsOf(std::string_view word);

}  // namespace poinsot::scene
