// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_text.h"

#include <fmt/format.h>

#include "core/text.h"
#include "scene/keys/tensor_text.h"
#include "scene/limits.h"

namespace poinsot::scene {
namespace {

std::string_view unitOfRange(const Key& key) {
  return key.range.unit.empty() ? siUnit(key.dimension) : key.range.unit;
}

bool unlimited(const Range& range) { return range.most == Range{}.most; }

std::string listed(const Key& key) { return fmt::format("[{0}](#{0})", key.wordList); }

std::string several(const Key& key, std::string_view count) {
  return fmt::format("{} {}", count, pluralName(key.dimension));
}

}  // namespace

std::string wordsText(const Key& key) { return fmt::format("one of \"{}\"", core::joined(key.words, "\", \"")); }

std::string tableText(std::string_view table) {
  if (table.ends_with("[]")) return fmt::format("[[{}]]", table.substr(0, table.size() - 2));
  return isTableArray(table) ? fmt::format("[[{}]]", table) : fmt::format("[{}]", table);
}

std::string unitSuffix(std::string_view unit) { return unit.empty() ? "" : fmt::format(" {}", unit); }

std::string numbersText(const Key& key) {
  const Range& range = key.range;
  if (unlimited(range)) return "";
  if (range.least == range.most) return fmt::format("{:g}", range.least);
  const std::string text =
      fmt::format("from {:g} to {:g}{}", range.least, range.most, unitSuffix(unitOfRange(key)));
  return range.ofSize ? "zero, or in magnitude " + text : text;
}

std::string rangeText(const Key& key) {
  switch (key.type) {
    case ValueType::kBool:
    case ValueType::kColor:
      return "";
    case ValueType::kText:
      return fmt::format("at most {} characters", key.range.most);
    case ValueType::kLines:
      return fmt::format("at most {} lines of {} characters", kMostLines, key.range.most);
    case ValueType::kWord:
      return key.wordList.empty() ? wordsText(key) : fmt::format("one of the {}", listed(key));
    case ValueType::kQuaternion:
      return "norm " + numbersText(key);
    case ValueType::kPixels:
      return numbersText(key) + ", even";
    case ValueType::kMoment:
      return fmt::format("{}, or one of \"{}\" and a number", numbersText(key), core::joined(key.words, "\", \""));
    case ValueType::kWords:
      return fmt::format("{}, each once", key.wordList.empty()
                                              ? fmt::format("\"{}\"", core::joined(key.words, "\", \""))
                                              : listed(key));
    default:
      break;
  }
  if (key.words.empty()) return numbersText(key);
  return fmt::format("{}, or \"{}\"", numbersText(key), core::joined(key.words, "\", \""));
}

std::string typeText(const Key& key) {
  switch (key.type) {
    case ValueType::kNumber:
      break;
    case ValueType::kInteger:
      return "a whole number";
    case ValueType::kBool:
      return "true or false";
    case ValueType::kColor:
      return "a colour \"#RRGGBB\" in hexadecimal digits";
    case ValueType::kText:
      return "text";
    case ValueType::kWord:
      return wordsText(key);
    case ValueType::kVector:
      return "an array of " + several(key, "three");
    case ValueType::kPerAxis:
      return "an array of " + several(key, "three") + ", or one for all three";
    case ValueType::kExtents:
      return "an array of " + several(key, "three") + " (two for a flat shape), or one for all";
    case ValueType::kMatrix:
      return fmt::format("three rows {} of {}", kTensorLayout, pluralName(key.dimension));
    case ValueType::kQuaternion:
      return "an array of four numbers w, x, y, z";
    case ValueType::kFrameRate:
      return "a number or a fraction such as \"30000/1001\"";
    case ValueType::kPixels:
      return "an array of width and height";
    case ValueType::kCell:
      return "an array of two whole numbers";
    case ValueType::kNumbers:
      return fmt::format("an array of {}, at most {}", several(key, "one or more"), kMostNumbers);
    case ValueType::kWords:
      if (!key.wordList.empty()) return fmt::format("an array of {}", key.wordList);
      return fmt::format("an array of words of \"{}\"", core::joined(key.words, "\", \""));
    case ValueType::kPair:
      return "an array of " + several(key, "two");
    case ValueType::kMoment:
      return fmt::format("{}, or an event and its number, such as \"{} 1\" (events are {})",
                         quantityName(key.dimension), key.words[0], core::joined(key.words, ", "));
    case ValueType::kLines:
      return "text, or an array of lines";
  }
  const std::string number(quantityName(key.dimension));
  return key.words.empty() ? number : fmt::format("{} or \"{}\"", number, core::joined(key.words, "\", \""));
}

}  // namespace poinsot::scene
