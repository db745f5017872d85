// SPDX-License-Identifier: Apache-2.0
#include "scene/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "core/text.h"
#include "scene/keys/keys.h"

namespace poinsot::scene {
namespace {

constexpr std::string_view kForms = "a range is FROM..TO:COUNT, such as 10..50 rpm:5, or FROM..TO:COUNT:log";

struct Number {
  double value = 0;
  std::string typed, unit;
};

/// Parses a number, with a unit if it has one, such as "10 rpm"; nullopt if the text does not begin with a number.
std::optional<Number> numberIn(std::string_view text) {
  text = core::trimmed(text);
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  double value = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (status != std::errc() || !std::isfinite(value)) return std::nullopt;
  const auto length = static_cast<std::size_t>(end - text.data());
  return Number{value, std::string(text.substr(0, length)), std::string(core::trimmed(text.substr(length)))};
}

/// Returns whether the value of a key consists of numbers. False for an unknown key, which is reported later.
bool takesNumbers(std::string_view path) {
  const Key* key = findKey(path);
  if (!key) return false;
  switch (key->type) {
    case ValueType::kNumber:
    case ValueType::kInteger:
    case ValueType::kVector:
    case ValueType::kPerAxis:
    case ValueType::kExtents:
    case ValueType::kQuaternion:
    case ValueType::kNumbers:
    case ValueType::kPair:
    case ValueType::kMatrix:
      return true;
    default:
      return false;
  }
}

/// Returns whether the value of a key is a word, or true or false.
bool takesWords(std::string_view path) {
  const Key* key = findKey(path);
  return key && (key->type == ValueType::kWord || key->type == ValueType::kBool);
}

/// Part of an override that may be a range, with the text before and after it.
struct Found {
  std::string key, before, range, after;
  std::optional<int> element;
  bool quoted = false;
};

class Reader {
 public:
  Reader(Found found, int most) : found_(std::move(found)), most_(most) {}

  SweepAxis axis() const {
    if (const auto words = words_()) return ofWords(*words);
    const std::vector<Number> numbers = found_.range.find('|') == std::string::npos ? spread() : listed();
    SweepAxis axis{found_.key, found_.element, unitOf(numbers), {}, false, found_.before, found_.after};
    for (const Number& number : numbers) {
      std::string text = axis.unit.empty() ? number.typed : number.typed + " " + axis.unit;
      // In a list, text with a unit needs quotes. A single value does not.
      if (!axis.unit.empty() && found_.element && !found_.quoted) text = fmt::format("\"{}\"", text);
      axis.values.push_back({std::move(text), number.typed});
    }
    if (axis.unit.empty()) axis.unit = siUnit(findKey(found_.key)->dimension);
    return axis;
  }

 private:
  std::vector<std::string> parts() const {
    std::vector<std::string> parts;
    for (std::string_view rest = found_.range;;) {
      const auto bar = rest.find('|');
      parts.emplace_back(core::trimmed(rest.substr(0, bar)));
      if (bar == std::string_view::npos) return parts;
      rest.remove_prefix(bar + 1);
    }
  }

  /// Returns the words that the key allows; empty if it has none.
  static std::vector<std::string> allowedWords(const Key& key) {
    if (key.type == ValueType::kBool) return {"false", "true"};
    return {key.words.begin(), key.words.end()};
  }

  /// Returns the values if they are words of the key. Returns nullopt if they are to be numbers.
  std::optional<std::vector<std::string>> words_() const {
    const Key& key = *findKey(found_.key);
    const std::vector<std::string> given = parts(), allowed = allowedWords(key);
    const auto isAllowed = [&](const std::string& word) {
      return std::ranges::find(allowed, word) != allowed.end();
    };
    if (std::ranges::all_of(given, isAllowed)) return given;
    if (takesNumbers(found_.key)) return std::nullopt;
    const auto wrong = std::ranges::find_if_not(given, isAllowed);
    const auto near = core::closest(*wrong, allowed);
    refuse(fmt::format("'{}' is not one of {}{}", core::printable(*wrong), core::joined(allowed, ", "),
                       near ? fmt::format("; did you mean '{}'?", *near) : ""));
  }

  SweepAxis ofWords(const std::vector<std::string>& words) const {
    SweepAxis axis{found_.key, found_.element, "", {}, true, found_.before, found_.after};
    const bool needsQuotes = !found_.quoted && findKey(found_.key)->type != ValueType::kBool;
    for (const std::string& word : words) axis.values.push_back({needsQuotes ? "\"" + word + "\"" : word, word});
    return axis;
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw core::usageError(
        fmt::format("-D {}: '{}': {}", core::printable(found_.key), core::printable(found_.range), why));
  }

  /// Returns the unit of all numbers. A number without a unit gets the unit of the others.
  std::string unitOf(const std::vector<Number>& numbers) const {
    std::string unit;
    for (const Number& number : numbers) {
      if (number.unit.empty()) continue;
      if (!unit.empty() && number.unit != unit)
        refuse(fmt::format("all values must have the same unit, got {} and {}", core::printable(unit),
                           core::printable(number.unit)));
      unit = number.unit;
    }
    return unit;
  }

  std::vector<Number> listed() const {
    std::vector<Number> numbers;
    for (std::string_view rest = found_.range;;) {
      const auto bar = rest.find('|');
      const auto number = numberIn(rest.substr(0, bar));
      if (!number) refuse("expected numbers between the bars, such as 1|2|5");
      numbers.push_back(*number);
      if (bar == std::string_view::npos) return numbers;
      rest.remove_prefix(bar + 1);
    }
  }

  std::vector<Number> spread() const {
    const std::string_view text = found_.range;
    const auto dots = text.find("..");
    const auto colon = text.find(':', dots);
    const auto from = numberIn(text.substr(0, dots));
    if (text.find("...", dots) == dots) refuse("write two dots between the ends, not three");
    if (from && colon == std::string_view::npos)
      refuse(fmt::format("the number of values is missing; {}", kForms));
    if (!from) refuse(std::string(kForms));
    const auto to = numberIn(text.substr(dots + 2, colon - dots - 2));
    if (!to) refuse(std::string(kForms));
    const auto [count, logarithmic] = countIn(text.substr(colon + 1));
    return logarithmic ? inRatios(*from, *to, count) : even(*from, *to, count);
  }

  std::pair<int, bool> countIn(std::string_view text) const {
    const auto colon = text.find(':');
    const std::string_view word = colon == std::string_view::npos ? "" : core::trimmed(text.substr(colon + 1));
    if (colon != std::string_view::npos && word != "log") refuse(std::string(kForms));
    const std::string_view digits = core::trimmed(text.substr(0, colon));
    int count = 0;
    const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
    const bool whole = end == digits.data() + digits.size() && status != std::errc::invalid_argument;
    if (!whole) refuse(std::string(kForms));
    if (status != std::errc() || count < 2 || count > most_)
      refuse(fmt::format("a range has from 2 to {} values, got {}", most_, core::printable(digits)));
    return {count, word == "log"};
  }

  static std::string unitOfEnds(const Number& from, const Number& to) {
    return from.unit.empty() ? to.unit : from.unit;
  }

  static std::string fixed(double x, int decimals) {
    std::string digits = fmt::format("{:.{}f}", x, decimals);
    const bool zero = digits.find_first_of("123456789") == std::string::npos;
    return zero && digits[0] == '-' ? digits.substr(1) : digits;
  }

  /// Formats x with few digits. Uses a power of ten if x is large or needs many decimals.
  static std::string digitsOf(double x, int decimals) {
    constexpr int kMostDecimals = 9;
    constexpr double kMostWritten = 1e7;
    return decimals > kMostDecimals || std::abs(x) >= kMostWritten ? fmt::format("{:.6g}", x) : fixed(x, decimals);
  }

  // Returns `count` equally spaced numbers, each rounded to the same few decimals. The rounding error is at most a
  // hundredth of a step, which is not visible. The rounded numbers are both printed and used.
  std::vector<Number> even(const Number& from, const Number& to, int count) const {
    if (from.value == to.value) refuse("both ends are the same");
    unitOf({from, to});
    const double step = (to.value - from.value) / (count - 1);
    const auto exact = [&](int i) { return i == count - 1 ? to.value : from.value + step * i; };
    const auto off = [&](int i, int decimals) {
      return std::abs(numberIn(fixed(exact(i), decimals))->value - exact(i)) > 1e-2 * std::abs(step);
    };
    int decimals = 0;
    for (int i = 0; i < count; ++i)
      while (decimals < 18 && off(i, decimals)) ++decimals;
    std::vector<Number> numbers;
    for (int i = 0; i < count; ++i) {
      const std::string digits = digitsOf(exact(i), decimals);
      numbers.push_back({exact(i), digits, unitOfEnds(from, to)});
    }
    return numbers;
  }

  std::vector<Number> inRatios(const Number& from, const Number& to, int count) const {
    if (!(from.value / to.value > 0))
      refuse("a logarithmic range needs two ends of the same sign, neither of them 0");
    if (from.value == to.value) refuse("both ends are the same");
    unitOf({from, to});
    std::vector<Number> numbers;
    for (int i = 0; i < count; ++i) {
      const double exact = from.value * std::pow(to.value / from.value, static_cast<double>(i) / (count - 1));
      numbers.push_back({exact, fmt::format("{:.3g}", exact), unitOfEnds(from, to)});
    }
    numbers.front().typed = from.typed;
    numbers.back().typed = to.typed;
    return numbers;
  }

  Found found_;
  int most_;
};

bool isRange(std::string_view text) {
  return text.find("..") != std::string_view::npos || text.find('|') != std::string_view::npos;
}

/// Returns whether a text contains another notation for a range, such as 1:3:5, 1 to 3 or 1…3.
bool meansRange(std::string_view text) {
  constexpr std::string_view kOtherSeparators[] = {":", " to ", "\u2026", "\u2013"};
  return std::ranges::any_of(kOtherSeparators,
                             [&](std::string_view way) { return text.find(way) != std::string_view::npos; });
}

/// Returns the index of the list element at a position in the text; nullopt outside a list.
std::optional<int> elementAt(std::string_view value, std::size_t place) {
  const auto before = value.substr(0, place);
  if (std::ranges::count(before, '[') <= std::ranges::count(before, ']')) return std::nullopt;
  return static_cast<int>(std::ranges::count(before.substr(before.rfind('[')), ','));
}

/// Splits an override around the number or range at a position, which brackets, commas or quotes delimit.
Found foundAt(const std::string& override, std::size_t equals, std::size_t place) {
  constexpr std::string_view kDelimiters = "[],\"'";
  const auto begin = std::max(override.find_last_of(kDelimiters, place) + 1, equals + 1);  // npos + 1 is 0
  const auto end = std::min(override.find_first_of(kDelimiters, place), override.size());
  Found found{std::string(core::trimmed(std::string_view(override).substr(0, equals))), override.substr(0, begin),
              std::string(core::trimmed(std::string_view(override).substr(begin, end - begin))),
              override.substr(end), elementAt(std::string_view(override).substr(equals + 1), place - equals - 1)};
  found.quoted = found.before.ends_with('"') || found.before.ends_with('\'');
  return found;
}

}  // namespace

std::string SweepAxis::override(std::size_t value) const { return before + values.at(value).text + after; }

bool hasRange(std::string_view override) {
  const auto equals = override.find('=');
  if (equals == std::string_view::npos) return false;
  const std::string_view key = core::trimmed(override.substr(0, equals)), value = override.substr(equals);
  return takesNumbers(key) ? isRange(value) : takesWords(key) && value.find('|') != std::string_view::npos;
}

std::optional<SweepAxis> sweepAxis(const std::string& override, int most) {
  const auto equals = override.find('=');
  if (equals == std::string::npos) return std::nullopt;
  if (!hasRange(override)) {
    const bool numbers = takesNumbers(core::trimmed(std::string_view(override).substr(0, equals)));
    if (!numbers || !meansRange(std::string_view(override).substr(equals))) return std::nullopt;
    throw core::usageError(fmt::format("-D {}: {}", core::printable(override), kForms));
  }
  const auto place = std::min(override.find("..", equals), override.find('|', equals));
  const Found found = foundAt(override, equals, place);
  if (isRange(found.after))
    throw core::usageError(
        fmt::format("-D {}: a key may have only one range; give a second range to another key with another -D",
                    core::printable(override)));
  return Reader(found, most).axis();
}

}  // namespace poinsot::scene
