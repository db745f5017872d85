// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What the names of a scene file mean, for people who write one.
namespace poinsot::scene {

struct Explanation {
  struct Row {
    std::string name, text;
  };

  std::string title;      ///< "camera.fov", "[camera]"
  std::string help;       ///< empty of a table
  std::vector<Row> rows;  ///< what it takes, its default; of a table its keys
};

/// Of a key by its path ("camera.fov", "body.part[3].mass"), of a table ("camera", "[[body.part]]"); of a name
/// alone all keys that have it ("fov"), a shape, a body of the catalogue, a quantity; of "", all tables.
/// @param otherWords  words that are explained elsewhere, which may be the nearest one, too
/// @throws core::Error(kUsage) of any other word, with the nearest one.
std::vector<Explanation> explain(std::string_view word, const std::vector<std::string>& otherWords = {});

/// The same, empty for any other word.
std::vector<Explanation> explanationsOf(std::string_view word);

}  // namespace poinsot::scene
