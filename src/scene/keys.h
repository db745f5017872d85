// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/rational.h"
#include "scene/draft.h"
#include "scene/units.h"

/// The one table of what a scene may say. The parser's checks, the JSON Schema and the reference come from it.
namespace poinsot::scene {

enum class ValueType {
  kNumber,  ///< with a dimension or without; besides, one of `words` where there are any
  kInteger,
  kBool,
  kText,        ///< at most range.most characters, no control characters
  kWord,        ///< one of `words`
  kVector,      ///< three numbers
  kExtents,     ///< three numbers, or one for all three
  kQuaternion,  ///< four numbers w, x, y, z; range is of the norm
  kFrameRate,   ///< an integer, a decimal, or "30000/1001"
  kPixels,      ///< width and height, even; range is of each
};

/// Both ends included, in `unit` (of the key's dimension; empty: SI).
struct Range {
  double least = -std::numeric_limits<double>::max();
  double most = std::numeric_limits<double>::max();
  std::string_view unit{};
  bool ofSize = false;  ///< of the absolute value; zero is in range
};

/// One of Key::words.
struct Word {
  int index = 0;
};

/// A value that passed its checks, in SI.
using Checked = std::variant<bool, std::int64_t, double, std::string, std::vector<double>, core::Rational, Word>;

struct Key {
  std::string_view path;  ///< "camera.fov"
  ValueType type = ValueType::kNumber;
  Dimension dimension = Dimension::kNone;
  Range range{};
  std::vector<std::string_view> words{};
  std::string_view fallback{};  ///< TOML; read by the same route as a file; empty: none
  std::string_view example{};   ///< TOML; a value other than the default
  std::string_view help{};      ///< one line
  std::function<void(Draft&, const Checked&)> put{};
  bool required = false;
};

const std::vector<Key>& keys();

/// The key of that path, or null.
const Key* findKey(std::string_view path);

/// Whether some key lies below: "show", "show.plane".
bool isTable(std::string_view path);

/// Names directly below a table ("" is the root): keys and tables.
std::vector<std::string> namesBelow(std::string_view table);

/// "show.plane" for "show.plane.opacity"; "" for "schema".
std::string_view tableOf(std::string_view path);
/// "opacity" for "show.plane.opacity".
std::string_view nameOf(std::string_view path);

/// Whether `show.plane = false` may stand for `show.plane.visible = false`.
bool hasVisible(std::string_view table);

}  // namespace poinsot::scene
