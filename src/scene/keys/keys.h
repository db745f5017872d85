// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/rational.h"
#include "scene/keys/draft.h"
#include "scene/limits.h"
#include "scene/units.h"

/// Table of all keys of a scene. The checks of the parser, the JSON Schema and the reference use this table.
namespace poinsot::scene {

enum class ValueType {
  kNumber,  ///< number with the dimension of the key; or one of `words`, if the key has words
  kInteger,
  kBool,
  kColor,       ///< text such as "#RRGGBB"
  kText,        ///< text without control characters; range.most limits the number of characters
  kWord,        ///< one of `words`
  kVector,      ///< three numbers
  kPerAxis,     ///< three numbers, or one number for all three
  kExtents,     ///< three numbers, or two for a flat shape, or one number for all
  kMatrix,      ///< symmetric 3x3 matrix as three rows of three numbers
  kQuaternion,  ///< four numbers w, x, y, z; `range` limits their norm
  kFrameRate,   ///< integer, decimal, or fraction such as "30000/1001"
  kPixels,      ///< width and height, both even; `range` limits each
  kCell,        ///< column and row, or numbers of columns and rows; `range` limits each
  kWords,       ///< array of some of `words`, none repeated
  kNumbers,     ///< array of 1 to kMostNumbers numbers
  kPair,        ///< two numbers
  kMoment,      ///< number, or one of `words`, which may be followed by a number from 1: "flip 2"
  kLines,       ///< array of lines, or text with line ends; `range` limits the characters of a line
};

constexpr std::size_t kMostNumbers = 60;

/// Range of a number in `unit`, both ends included. If `unit` is empty, the unit is the key's SI unit.
struct Range {
  double least = -std::numeric_limits<double>::max();
  double most = std::numeric_limits<double>::max();
  std::string_view unit{};
  bool ofSize = false;           ///< the range limits the absolute value; 0 is always allowed
  std::optional<Limit> limit{};  ///< limit of the user that replaces `most`
};

/// One of the words in Key::words, as its index.
struct Word {
  int index = 0;
};

/// One of the words in Key::words and a number, such as "flip 2".
struct NumberedWord {
  int index = 0;
  int number = 1;
};

/// Value that passed the check of its key, in SI units.
using Checked = std::variant<bool, std::int64_t, double, std::string, std::vector<double>, core::Rational, Word,
                             NumberedWord, std::vector<Word>, std::vector<std::string>>;

struct Key {
  std::string path;  ///< path such as "camera.fov"; "body.part[].mass" for a key of all elements of [[body.part]]
  ValueType type = ValueType::kNumber;
  Dimension dimension = Dimension::kNone;
  Range range{};
  std::vector<std::string_view> words{};
  std::string_view wordList{};  ///< heading of the reference that lists the words; empty if the key lists them
  std::string_view fallback{};  ///< default as TOML, checked like a scene's value; empty if the key has none
  std::string_view example{};   ///< example as TOML, different from the default
  std::string_view help{};      ///< description of the key in one line
  bool isTex = false;           ///< text with TeX, which a TextCheck validates
  /// Function that returns advice for an error message, such as "; the nearest ...". Receives all numbers of the
  /// value, if at least one is out of range. Null if the key has no advice.
  std::string (*advice)(std::span<const double>) = nullptr;
  /// Stores a checked value in the draft.
  /// @param element  index in an array of tables, from 0; 0 for other keys
  std::function<void(Draft&, std::size_t element, const Checked&)> put{};
};

const std::vector<Key>& keys();

/// Returns the path without its index, as in the table of keys: "body.part[].mass" for "body.part[3].mass".
std::string patternOf(std::string_view path);

/// Returns the index in a path: 3 for "body.part[3].mass". Returns 0 if the path has no index.
std::size_t elementOf(std::string_view path);

/// Returns the key with this path, or null. The path may contain an index where the path of the key has [].
const Key* findKey(std::string_view path);

/// Returns whether a path names a table with keys or tables in it. True for "show", "show.plane" and
/// "body.part[3]", false for the array "body.part".
bool isTable(std::string_view path);

/// Returns whether a path names an array of tables, such as "body.part".
bool isTableArray(std::string_view path);

/// Returns the names of the keys, tables and arrays of tables directly in a table, without [] at the end.
/// @param table  path of the table; "" for the top level
std::vector<std::string> namesBelow(std::string_view table);

/// Returns the path of the table that contains a key: "show.plane" for "show.plane.opacity", "body.part[]" for
/// "body.part[].mass", "" for "schema".
std::string_view tableOf(std::string_view path);
/// Returns the path of a key in a table: "show.plane.opacity" for "show.plane" and "opacity". The top level is "".
std::string pathBelow(std::string_view table, std::string_view name);
/// Returns the last name of a path: "opacity" for "show.plane.opacity".
std::string_view nameOf(std::string_view path);

/// Returns whether a key of a view repeats a key of the scene, such as "view[].camera.fov".
bool repeatsInView(const Key& key);

/// Returns whether the table has a key "visible", so that `show.plane = false` means `show.plane.visible = false`.
bool hasVisible(std::string_view table);
/// Returns whether a thing is hidden by default. Any key of its table shows the thing, unless `visible` is false.
bool isExtra(std::string_view table);

}  // namespace poinsot::scene
