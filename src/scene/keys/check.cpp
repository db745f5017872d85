// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/number.h"
#include "core/rational.h"
#include "core/text.h"
#include "scene/document/text_lines.h"
#include "scene/keys/key_text.h"
#include "scene/keys/tensor_text.h"
#include "scene/limits.h"

namespace poinsot::scene {
namespace {

std::size_t mirrored(std::size_t place) { return 3 * (place % 3) + place / 3; }

/// Returns the first element above the diagonal that differs from its mirror image; empty for a symmetric matrix.
/// @param rows  nine elements of a 3x3 matrix, row by row
std::optional<std::size_t> asymmetric(const std::vector<double>& rows) {
  for (const std::size_t above : {1, 2, 5})
    if (rows[above] != rows[mirrored(above)]) return above;
  return std::nullopt;
}

bool isUtf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = core::firstCodePoint(text).length;
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

class Checker {
 public:
  Checker(const Key& key, std::string_view path, Problems& problems)
      : key_(key), path_(path), problems_(problems) {}

  std::optional<Checked> operator()(const Node& node) {
    switch (key_.type) {
      case ValueType::kNumber:
        return numberOrWord(node);
      case ValueType::kInteger:
        return integer(node);
      case ValueType::kBool:
        return flag(node);
      case ValueType::kColor:
        return color(node);
      case ValueType::kText:
        return text(node);
      case ValueType::kWord:
        return word(node);
      case ValueType::kVector:
        return wrapped(numbers(node, 3));
      case ValueType::kPerAxis:
        return perAxis(node, 3);
      case ValueType::kExtents:
        return extents(node);
      case ValueType::kMatrix:
        return matrix(node);
      case ValueType::kQuaternion:
        return quaternion(node);
      case ValueType::kFrameRate:
        return frameRate(node);
      case ValueType::kPixels:
        return pixels(node);
      case ValueType::kCell:
        return cell(node);
      case ValueType::kWords:
        return someWords(node);
      case ValueType::kNumbers:
        return someNumbers(node);
      case ValueType::kPair:
        return wrapped(numbers(node, 2));
      case ValueType::kMoment:
        return moment(node);
      case ValueType::kLines:
        return lines(node);
    }
    return std::nullopt;
  }

 private:
  std::nullopt_t refuse(const Node& node, std::string_view message) {
    problems_.add(node.place, fmt::format("{}: {}", path_, message));
    return std::nullopt;
  }

  std::nullopt_t refuseType(const Node& node, std::string_view advice = "") {
    return refuse(node, fmt::format("expected {}, got {}{}", typeText(key_), describe(node), advice));
  }

  static std::optional<Checked> wrapped(std::optional<std::vector<double>> numbers) {
    if (!numbers) return std::nullopt;
    return Checked(std::move(*numbers));
  }

  std::string elementText() const {
    if (key_.dimension == Dimension::kNone) return "a number";
    return fmt::format("{}, a number in {} or text with a unit such as {}", quantityName(key_.dimension),
                       siUnit(key_.dimension), someUnits(key_.dimension));
  }

  std::optional<double> finite(const Node& node) {
    if (const auto* integer = node.as<std::int64_t>()) return static_cast<double>(*integer);
    // Elements of a quaternion have no unit. Even percent is not allowed, because the norm is arbitrary.
    if (const auto* text = node.as<std::string>(); text && key_.type != ValueType::kQuaternion)
      return quantity(node, *text);
    const auto* number = node.as<double>();
    if (!number) return refuse(node, fmt::format("expected {}, got {}", elementText(), describe(node)));
    if (!std::isfinite(*number)) return refuse(node, fmt::format("must be a finite number, got {}", *number));
    return *number;
  }

  std::optional<double> quantity(const Node& node, const std::string& text) {
    const Quantity read = parseQuantity(text, key_.dimension);
    if (!read.ok()) return refuse(node, read.problem);
    if (!std::isfinite(read.value)) return refuse(node, fmt::format("must be finite, got {}", describe(node)));
    return read.value;
  }

  bool inRange(double value) const {
    const Range& range = key_.range;
    if (range.ofSize && value == 0) return true;
    const double unit = unitFactor(range.unit, key_.dimension);
    const double tested = range.ofSize ? std::abs(value) : value;
    return tested >= range.least * unit && tested <= range.most * unit;
  }

  std::nullopt_t refuseRange(const Node& node, double value, std::string_view advice = "") {
    const bool sign =
        key_.range.least > 0 && key_.range.least < key_.range.most && value <= 0 && !key_.range.ofSize;
    const bool bare = !node.as<std::string>();
    constexpr double kHalfTurn_rad = 3.2;  // more is hardly meant as radians
    const std::string hint = bare && key_.dimension == Dimension::kAngle && std::abs(value) > kHalfTurn_rad
                                 ? fmt::format("; a bare angle is in radians, write \"{} deg\" for degrees", value)
                                 : "";
    return refuse(node, fmt::format("must be {}{}, got {}{}{}{}", sign ? "positive, " : "", numbersText(key_),
                                    describe(node), bare ? unitSuffix(siUnit(key_.dimension)) : "",
                                    hint + beyondLimit(value), advice));
  }

  std::string beyondLimit(double value) const {
    return key_.range.limit && value > key_.range.most ? "; " + howToRaise(*key_.range.limit) : "";
  }

  std::optional<double> number(const Node& node) {
    const auto value = finite(node);
    if (value && !inRange(*value)) return refuseRange(node, *value);
    return value;
  }

  std::optional<Checked> numberOrWord(const Node& node) {
    const auto* text = node.as<std::string>();
    for (std::size_t i = 0; text && i < key_.words.size(); ++i)
      if (key_.words[i] == *text) return Checked(Word{static_cast<int>(i)});
    if (text && !key_.words.empty() && !parseQuantity(*text, key_.dimension).ok()) return refuseType(node);
    const auto value = number(node);
    return value ? std::optional<Checked>(*value) : std::nullopt;
  }

  std::optional<Checked> moment(const Node& node) {
    if (const auto* text = node.as<std::string>(); text && !parseQuantity(*text, key_.dimension).ok()) {
      const auto event = numberedWord(*text);
      return event ? std::optional<Checked>(*event) : refuseType(node);
    }
    const auto value = number(node);
    return value ? std::optional<Checked>(*value) : std::nullopt;
  }

  std::optional<NumberedWord> numberedWord(std::string_view text) const {
    const std::size_t blank = text.find(' ');
    const auto word = std::ranges::find(key_.words, text.substr(0, blank));
    const auto number = blank == text.npos ? 1 : core::parseInteger<int>(core::trimmed(text.substr(blank)));
    if (word == key_.words.end() || !number || *number < 1) return std::nullopt;
    return NumberedWord{static_cast<int>(word - key_.words.begin()), *number};
  }

  std::optional<Checked> integer(const Node& node) {
    const auto* value = node.as<std::int64_t>();
    if (!value) return refuseType(node);
    if (!inRange(static_cast<double>(*value))) return refuseRange(node, static_cast<double>(*value));
    return Checked(*value);
  }

  std::optional<Checked> flag(const Node& node) {
    const auto* value = node.as<bool>();
    if (!value) return refuseType(node);
    return Checked(*value);
  }

  std::optional<Checked> color(const Node& node) {
    const auto* text = node.as<std::string>();
    const auto hex = text ? hexColor(*text) : std::nullopt;
    if (hex) return Checked(*hex);
    const std::string meant = text ? sixDigits(*text) : "";
    if (meant.empty()) return refuseType(node);
    return refuse(node,
                  fmt::format("expected {}, got {}; did you mean \"{}\"?", typeText(key_), describe(node), meant));
  }

  static std::optional<std::int64_t> hexColor(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    std::int64_t hex = 0;
    const char* end = text.data() + text.size();
    const bool good = std::from_chars(text.data() + 1, end, hex, 16).ptr == end && hex >= 0;
    return good ? std::optional(hex) : std::nullopt;
  }

  /// Returns a colour with six digits: "#cc0000" for "#c00" and "cc0000". Empty if the text is not such a colour.
  static std::string sixDigits(std::string_view text) {
    if (text.starts_with('#')) text.remove_prefix(1);
    std::string all = "#";
    for (const char digit : text.substr(0, 7)) all.append(text.size() == 3 ? 2 : 1, digit);
    return hexColor(all) ? all : "";
  }

  std::optional<Checked> text(const Node& node) {
    const auto* value = node.as<std::string>();
    if (!value) return refuseType(node);
    if (static_cast<double>(characterCount(*value)) > key_.range.most)
      return refuse(
          node, fmt::format("may have at most {} characters, got {}", key_.range.most, characterCount(*value)));
    if (!isUtf8(*value))
      return refuse(node, fmt::format("is not valid UTF-8, got {}; save the file as UTF-8", describe(node)));
    // printable() replaces the characters that neither a terminal nor a picture can show. It does not shorten
    // texts of at most 200 characters.
    if (core::printable(*value) != *value)
      return refuse(node, fmt::format("must not contain line ends or other control characters, got {} (write "
                                      "mathematics in single quotes, which keep backslashes: '$\\theta$')",
                                      describe(node)));
    return Checked(*value);
  }

  /// Checks lines of text. A string may contain several lines; a line end at the end of the string adds no line.
  std::optional<Checked> lines(const Node& node) {
    const std::vector<Node> given = linesOf(node);
    if (given.empty()) return refuseType(node);
    if (given.size() > kMostLines)
      return refuse(node, fmt::format("may have at most {} lines, got {}", kMostLines, given.size()));
    std::vector<std::string> all;
    for (const Node& line : given) {
      const auto checked = text(line);
      if (!checked) return std::nullopt;
      all.push_back(std::get<std::string>(*checked));
    }
    return Checked(std::move(all));
  }

  /// Checks that a value is one of the words of the key. A word that is a number may be given without quotes.
  std::optional<Checked> word(const Node& node) {
    const auto* value = node.as<std::string>();
    const auto* number = node.as<std::int64_t>();
    const std::string given = value ? *value : number ? fmt::format("{}", *number) : "";
    for (std::size_t i = 0; i < key_.words.size(); ++i)
      if (key_.words[i] == given) return Checked(Word{static_cast<int>(i)});
    if (!value) return refuseType(node);
    const auto near = meantWord(*value);
    // With a suggestion, the message does not list the words, because a long list would hide the suggestion.
    const std::string expected =
        near && !key_.wordList.empty() ? fmt::format("one of the {}", key_.wordList) : wordsText(key_);
    const std::string hint = near ? fmt::format("; did you mean \"{}\"?", *near) : "";
    return refuse(node, fmt::format("expected {}, got {}{}", expected, describe(node), hint));
  }

  /// Returns the word that is most similar to a misspelt word, such as "theta_vertical" for "theta_vert",
  /// "omega_1" for "omega1", "omega" for "omega_magnitude".
  std::optional<std::string> meantWord(const std::string& given) const {
    constexpr std::size_t kLongest = 64;  // characters; the edit distance of longer text takes too long
    constexpr std::size_t kAddition = 3;  // characters after the underscore; a shorter addition may name an axis
    if (given.size() > kLongest) return std::nullopt;
    const auto begun = [&](std::string_view word) { return word.starts_with(given); };
    if (given.size() > kAddition && std::ranges::count_if(key_.words, begun) == 1)
      return std::string(*std::ranges::find_if(key_.words, begun));
    const std::size_t begin = given.find('_');
    if (!key_.wordList.empty() && begin != std::string::npos && given.size() > begin + kAddition)
      if (std::ranges::find(key_.words, std::string_view(given).substr(0, begin)) != key_.words.end())
        return given.substr(0, begin);
    return core::closest(given, {key_.words.begin(), key_.words.end()});
  }

  std::optional<Checked> someWords(const Node& node) {
    const auto* array = node.as<Node::Array>();
    if (!array || array->empty()) return refuseType(node);
    std::vector<Word> all;
    for (const Node& element : *array) {
      const bool isWord = element.as<std::string>() || element.as<std::int64_t>();
      const auto one = isWord ? word(element) : refuseType(element);
      if (!one) return std::nullopt;
      const Word given = std::get<Word>(*one);
      if (std::ranges::find(all, given.index, &Word::index) != all.end())
        return refuse(element, fmt::format("each word may be given once, got {} again", describe(element)));
      all.push_back(given);
    }
    return Checked(std::move(all));
  }

  std::optional<std::vector<double>> numbers(const Node& node, std::size_t count) {
    const auto* array = node.as<Node::Array>();
    if (array && array->size() > count && array->size() <= 2 * count && key_.type != ValueType::kQuaternion)
      return refuse(node, fmt::format("expected {}, got {}; write decimals with a point: 0.1", typeText(key_),
                                      describe(node)));
    if (!array || array->size() != count) return refuseType(node);
    std::vector<double> values;
    for (const Node& element : *array)
      if (const auto value = finite(element)) values.push_back(*value);
    if (values.size() != count) return std::nullopt;
    return key_.type == ValueType::kQuaternion || allInRange(*array, values) ? std::optional(values)
                                                                             : std::nullopt;
  }

  bool allInRange(const Node::Array& array, const std::vector<double>& values) {
    bool all = true;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!inRange(values[i])) {
        refuseRange(array[i], values[i], key_.advice ? key_.advice(values) : "");
        all = false;
      }
    return all;
  }

  std::optional<Checked> someNumbers(const Node& node) {
    const auto* array = node.as<Node::Array>();
    if (!array || array->empty() || array->size() > kMostNumbers) return refuseType(node);
    return wrapped(numbers(node, array->size()));
  }

  std::optional<Checked> perAxis(const Node& node, std::size_t count) {
    if (node.as<Node::Array>()) return wrapped(numbers(node, count));
    if (node.as<bool>() || node.as<Node::Table>() || node.as<DateOrTime>()) return refuseType(node);
    const auto value = number(node);
    return value ? std::optional<Checked>(std::vector<double>(count, *value)) : std::nullopt;
  }

  std::optional<Checked> extents(const Node& node) {
    const auto* array = node.as<Node::Array>();
    if (!array) return perAxis(node, 1);
    return wrapped(numbers(node, array->size() == 2 ? 2 : 3));
  }

  std::optional<Checked> matrix(const Node& node) {
    const auto* rows = node.as<Node::Array>();
    const std::string advice = layoutAdvice(node);
    if (!rows || rows->size() != 3 || !advice.empty()) return refuseType(node, advice);
    std::vector<double> values;
    for (const Node& row : *rows)
      if (const auto three = numbers(row, 3)) values.insert(values.end(), three->begin(), three->end());
    if (values.size() != 9) return std::nullopt;
    if (const auto above = asymmetric(values))
      return refuse(node, fmt::format("must be symmetric, got {} in row {} column {} and {} across the diagonal{}",
                                      values[*above], *above / 3 + 1, *above % 3 + 1, values[mirrored(*above)],
                                      triangleAdvice(node, values)));
    return wrapped(std::move(values));
  }

  std::optional<Checked> quaternion(const Node& node) {
    const auto values = numbers(node, 4);
    if (!values) return std::nullopt;
    const auto& q = *values;
    const double norm = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    if (norm == 0)
      return refuse(node, "must not be zero, got [0, 0, 0, 0]: a zero quaternion is not an orientation");
    if (!inRange(norm)) return refuse(node, fmt::format("its norm must be {}, got {}", numbersText(key_), norm));
    return wrapped(values);
  }

  // Checks a frame rate. A decimal is used exactly as written: 29.97 is 2997/100, not the nearest double.
  std::optional<Checked> frameRate(const Node& node) {
    std::string text;
    if (const auto* integer = node.as<std::int64_t>()) text = fmt::format("{}", *integer);
    if (const auto* number = node.as<double>()) text = fmt::format("{}", *number);
    if (const auto* string = node.as<std::string>()) text = *string;
    if (text.empty()) return refuseType(node);
    const auto rate = core::parseRational(text);
    if (!rate && node.as<std::string>()) return refuseType(node);
    if (const auto* number = node.as<double>(); !rate && number && inRange(*number))
      return refuse(node, fmt::format("has too many digits to be kept exactly, got {}; write a fraction such as "
                                      "\"30000/1001\"",
                                      describe(node)));
    if (!rate || !inRange(rate->value()))
      return refuse(node, fmt::format("must be {} frames per second, got {}{}", numbersText(key_), describe(node),
                                      rate ? beyondLimit(rate->value()) : ""));
    return Checked(*rate);
  }

  std::optional<Checked> pixels(const Node& node) {
    const auto* array = node.as<Node::Array>();
    if (!array || array->size() != 2) return refuseType(node);
    std::vector<double> sides;
    for (const Node& element : *array)
      if (const auto value = side(element)) sides.push_back(*value);
    if (sides.size() != 2) return std::nullopt;
    return wrapped(sides);
  }

  std::optional<Checked> cell(const Node& node) {
    const auto* array = node.as<Node::Array>();
    if (!array || array->size() != 2) return refuseType(node);
    std::vector<double> both;
    for (const Node& element : *array) {
      const auto one = element.as<std::int64_t>() ? integer(element) : refuseType(element);
      if (!one) return std::nullopt;
      both.push_back(static_cast<double>(std::get<std::int64_t>(*one)));
    }
    return wrapped(both);
  }

  std::optional<double> side(const Node& node) {
    const auto* value = node.as<std::int64_t>();
    if (!value) return refuse(node, fmt::format("expected a whole number of pixels, got {}", describe(node)));
    if (!inRange(static_cast<double>(*value)))
      return refuse(node, fmt::format("each side must be {} pixels, got {}{}", numbersText(key_), *value,
                                      beyondLimit(static_cast<double>(*value))));
    if (*value % 2 != 0)
      return refuse(node,
                    fmt::format("each side must be even (video stores colour for pairs of pixels), got {}; the "
                                "nearest even size is {}",
                                *value, *value + 1));
    return static_cast<double>(*value);
  }

  const Key& key_;
  std::string_view path_;
  Problems& problems_;
};

}  // namespace

std::optional<Checked> check(const Key& key, std::string_view path, const Node& node, Problems& problems,
                             const Limits& limits) {
  if (!key.range.limit) return Checker(key, path, problems)(node);
  Key bounded = key;
  bounded.range.most = static_cast<double>(limits[*key.range.limit]);
  return Checker(bounded, path, problems)(node);
}

}  // namespace poinsot::scene
