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

/// The one table of what a scene may say. The parser's checks, the JSON Schema and the reference come from it.
namespace poinsot::scene {

enum class ValueType {
  kNumber,  ///< with a dimension or without; besides, one of `words` where there are any
  kInteger,
  kBool,
  kColor,       ///< "#RRGGBB"
  kText,        ///< at most range.most characters, no control characters
  kWord,        ///< one of `words`
  kVector,      ///< three numbers
  kPerAxis,     ///< three numbers, or one for all three
  kExtents,     ///< three numbers (two for what is flat), or one for all
  kMatrix,      ///< three rows of three numbers, symmetric
  kQuaternion,  ///< four numbers w, x, y, z; range is of the norm
  kFrameRate,   ///< an integer, a decimal, or "30000/1001"
  kPixels,      ///< width and height, even; range is of each
  kCell,        ///< two whole numbers, of columns and of rows; range is of each
  kWords,       ///< some of `words`, each once
  kNumbers,     ///< one number or more, at most kMostNumbers
  kPair,        ///< two numbers
  kLines,       ///< lines of text, or one text with line ends; range is of each line's characters
};

constexpr std::size_t kMostNumbers = 60;  ///< of a kNumbers

/// Both ends included, in `unit` (of the key's dimension; empty: SI).
struct Range {
  double least = -std::numeric_limits<double>::max();
  double most = std::numeric_limits<double>::max();
  std::string_view unit{};
  bool ofSize = false;           ///< of the absolute value; zero is in range
  std::optional<Limit> limit{};  ///< `most` is its usual value, which the user may change
};

/// One of Key::words.
struct Word {
  int index = 0;
};

/// A value that passed its checks, in SI.
using Checked = std::variant<bool, std::int64_t, double, std::string, std::vector<double>, core::Rational, Word,
                             std::vector<Word>, std::vector<std::string>>;

struct Key {
  std::string path;  ///< "camera.fov"; "body.part[].mass" stands for that of each [[body.part]]
  ValueType type = ValueType::kNumber;
  Dimension dimension = Dimension::kNone;
  Range range{};
  std::vector<std::string_view> words{};
  std::string_view wordList{};  ///< the reference's heading under which many words are listed; empty: here
  std::string_view fallback{};  ///< TOML; read by the same route as a file; empty: none
  std::string_view example{};   ///< TOML; a value other than the default
  std::string_view help{};      ///< one line
  bool isTex = false;           ///< its text is set in type, so a TextCheck has its say
  /// Advice appended to the message about numbers of which some are out of range: "; the nearest ...". Null:
  /// none.
  std::string (*advice)(std::span<const double>) = nullptr;
  /// `element` counts from 0 in an array of tables and is 0 elsewhere.
  std::function<void(Draft&, std::size_t element, const Checked&)> put{};
};

const std::vector<Key>& keys();

/// Which key a path means: "body.part[].mass" for "body.part[3].mass".
std::string patternOf(std::string_view path);

/// 3 for "body.part[3].mass"; 0 where the path has no index.
std::size_t elementOf(std::string_view path);

/// The key of that path, or null. An index may stand for [].
const Key* findKey(std::string_view path);

/// Whether some key lies below: "show", "show.plane", "body.part[3]"; not "body.part".
bool isTable(std::string_view path);

/// Whether it is an array of such tables: "body.part".
bool isTableArray(std::string_view path);

/// Names directly below a table ("" is the root): keys, tables, and arrays of tables without their [].
std::vector<std::string> namesBelow(std::string_view table);

/// "show.plane" for "show.plane.opacity", "body.part[]" for "body.part[].mass"; "" for "schema".
std::string_view tableOf(std::string_view path);
/// "show.plane.opacity" for the two parts of it; the name alone in the root, which is "".
std::string pathBelow(std::string_view table, std::string_view name);
/// "opacity" for "show.plane.opacity".
std::string_view nameOf(std::string_view path);

/// Whether it repeats, in a view, a key of the scene: "view[].camera.fov".
bool repeatsInView(const Key& key);

/// Whether `show.plane = false` may stand for `show.plane.visible = false`.
bool hasVisible(std::string_view table);
/// Whether it is a thing that is not drawn unless asked for: by its key "visible", or by any other.
bool isExtra(std::string_view table);

}  // namespace poinsot::scene
