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

  std::string title;      ///< path of a key or header of a table, such as "camera.fov" or "[camera]"
  std::string help;       ///< description of a key or a value; empty for a table
  std::vector<Row> rows;  ///< type, units, default and example of a key; or the keys of a table
};

/// Explains a word of a scene: the path of a key ("camera.fov", "body.part[3].mass"), a table ("camera",
/// "[[body.part]]"), the name of one or several keys ("fov"), a shape, a body of the catalogue, a quantity or a
/// unit. The empty word lists all tables.
/// @param otherWords  words that another part of the program explains; the error may suggest them
/// @throws core::Error(kUsage) for an unknown word, suggesting the most similar word.
std::vector<Explanation> explain(std::string_view word, const std::vector<std::string>& otherWords = {});

/// Returns the same explanations as explain(). For an unknown word, returns none and does not throw.
std::vector<Explanation> explanationsOf(std::string_view word);

}  // namespace poinsot::scene
