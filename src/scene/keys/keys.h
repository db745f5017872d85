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

/// Table of all keys of a scene. The parser's checks, the JSON Schema and the reference are made from it.
namespace poinsot::scene {

enum class ValueType {
  kNumber,  ///< a number, with or without a dimension; or one of `words`, if there are any
  kInteger,
  kBool,
  kColor,       ///< "#RRGGBB"
  kText,        ///< at most range.most characters, no control characters
  kWord,        ///< one of `words`
  kVector,      ///< three numbers
  kPerAxis,     ///< three numbers, or one for all three
  kExtents,     ///< three numbers (two for what is flat), or one for all
  kMatrix,      ///< three rows of three numbers, symmetric
  kQuaternion,  ///< four numbers w, x, y, z; `range` limits the norm
  kFrameRate,   ///< an integer, a decimal, or "30000/1001"
  kPixels,      ///< width and height, even; `range` limits each
  kCell,        ///< two whole numbers, columns and rows; `range` limits each
  kWords,       ///< some of `words`, each once
  kNumbers,     ///< one number or more, at most kMostNumbers
  kPair,        ///< two numbers
  kLines,       ///< lines of text, or one text with line ends; `range` limits the characters of each line
};

constexpr std::size_t kMostNumbers = 60;

/// Range of a number in `unit`, both ends included. An empty unit is the SI unit of the key's dimension.
struct Range {
  double least = -std::numeric_limits<double>::max();
  double most = std::numeric_limits<double>::max();
  std::string_view unit{};
  bool ofSize = false;           ///< limits the absolute value; zero is always in range
  std::optional<Limit> limit{};  ///< limit that the user may change; replaces `most`, its default
};

/// Word of Key::words, by its index.
struct Word {
  int index = 0;
};

/// Value that passed its checks, in SI units.
using Checked = std::variant<bool, std::int64_t, double, std::string, std::vector<double>, core::Rational, Word,
                             std::vector<Word>, std::vector<std::string>>;

struct Key {
  std::string path;  ///< "camera.fov"; "body.part[].mass" for the key of each [[body.part]]
  ValueType type = ValueType::kNumber;
  Dimension dimension = Dimension::kNone;
  Range range{};
  std::vector<std::string_view> words{};
  std::string_view wordList{};  ///< heading of the reference that lists many words; empty: listed at the key
  std::string_view fallback{};  ///< default in TOML, validated like a scene file; empty: no default
  std::string_view example{};   ///< example in TOML, other than the default
  std::string_view help{};      ///< one line of text
  bool isTex = false;           ///< the text is set in type, so a TextCheck validates it
  /// Returns advice for the message about numbers of which some are out of range: "; the nearest ...". Null: no
  /// advice.
  std::string (*advice)(std::span<const double>) = nullptr;
  /// Stores a checked value in the draft. `element` counts from 0 in an array of tables and is 0 elsewhere.
  std::function<void(Draft&, std::size_t element, const Checked&)> put{};
};

const std::vector<Key>& keys();

/// Returns the path of a key in the table: "body.part[].mass" for "body.part[3].mass".
std::string patternOf(std::string_view path);

/// Returns the index in a path: 3 for "body.part[3].mass"; 0 for a path without an index.
std::size_t elementOf(std::string_view path);

/// Returns the key of a path, or null. The path may have an index in place of [].
const Key* findKey(std::string_view path);

/// Returns whether keys lie directly or indirectly below: "show", "show.plane", "body.part[3]"; not "body.part".
bool isTable(std::string_view path);

/// Returns whether a path names an array of tables: "body.part".
bool isTableArray(std::string_view path);

/// Returns the names directly below a table ("" is the root): keys, tables, and arrays of tables without their [].
std::vector<std::string> namesBelow(std::string_view table);

/// Returns "show.plane" for "show.plane.opacity", "body.part[]" for "body.part[].mass"; "" for "schema".
std::string_view tableOf(std::string_view path);
/// Returns "show.plane.opacity" for "show.plane" and "opacity"; only the name if the table is the root, "".
std::string pathBelow(std::string_view table, std::string_view name);
/// Returns "opacity" for "show.plane.opacity".
std::string_view nameOf(std::string_view path);

/// Returns whether a key repeats, in a view, a key of the scene: "view[].camera.fov".
bool repeatsInView(const Key& key);

/// Returns whether `show.plane = false` may stand for `show.plane.visible = false`.
bool hasVisible(std::string_view table);
/// Returns whether a thing is hidden by default. Its key "visible" or any other of its keys makes it visible.
bool isExtra(std::string_view table);

}  // namespace poinsot::scene
