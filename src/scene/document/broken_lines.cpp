// SPDX-License-Identifier: Apache-2.0
#include "scene/document/broken_lines.h"

#include <algorithm>
#include <string_view>

#include "core/text.h"
#include "scene/document/text_limits.h"

namespace poinsot::scene {
namespace {

constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_";
constexpr std::string_view kNameCharacters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";

/// Returns whether a line begins a table, perhaps with a mistake: "[motion]", "[[view", "[ body". Rows of a matrix
/// and texts in an array are different, because they begin with a number or a quote.
bool isHeaderLine(std::string_view line) {
  const std::string_view text = core::trimmed(line);
  const std::size_t name = text.find_first_not_of("[ \t");
  return text.starts_with('[') && name != std::string_view::npos &&
         kLetters.find(text[name]) != std::string_view::npos;
}

/// Returns whether a line begins with a key: "size = 3", "camera.fov =".
bool isKeyLine(std::string_view line) {
  const std::string_view key = core::trimmed(line.substr(0, line.find('=')));
  const auto isPart = [](char c) {
    return c == '.' || c == ' ' || kNameCharacters.find(c) != std::string_view::npos;
  };
  return line.find('=') != std::string_view::npos && !key.empty() && std::ranges::all_of(key, isPart);
}

bool beginsStatement(std::string_view line) { return isHeaderLine(line) || isKeyLine(line); }

/// Returns the first name in a header or in a key with dots: "motion" for "[motion.torque]" and "motion.L = 3".
std::string firstName(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_of(kNameCharacters), line.size());
  const std::size_t end = std::min(line.find_first_not_of(kNameCharacters, begin), line.size());
  return std::string(line.substr(begin, end - begin));
}

class Lines {
 public:
  Lines(const Source& source, const Limits& limits) : source_(source), limits_(limits) {
    const std::string& text = source.text();
    count_ = static_cast<int>(std::ranges::count(text, '\n')) + 1;
  }

  BrokenLines around(int line) const {
    const int first = isInArray(line) ? upTo(line) : line;
    if (isHeaderLine(source_.line(first)))
      return {first, beforeNext(first, isHeaderLine), firstName(source_.line(first))};
    const int last = isInArray(first + 1) ? std::max(line, beforeNext(first, beginsStatement)) : first;
    return {first, last, tableOfLine(first)};
  }

 private:
  bool isInArray(int line) const { return openArrayAtLine(source_, limits_, line).has_value(); }

  /// Returns the line at which the statement of a line begins.
  int upTo(int line) const {
    for (int above = line; above > 0; --above)
      if (beginsStatement(source_.line(above))) return above;
    return line;
  }

  int beforeNext(int line, bool (*begins)(std::string_view)) const {
    for (int below = line + 1; below <= count_; ++below)
      if (begins(source_.line(below))) return below - 1;
    return count_;
  }

  std::string tableOfLine(int line) const {
    for (int above = line; above > 0; --above)
      if (isHeaderLine(source_.line(above))) return firstName(source_.line(above));
    return isKeyLine(source_.line(line)) ? firstName(source_.line(line)) : "";
  }

  const Source& source_;
  const Limits& limits_;
  int count_ = 0;
};

}  // namespace

BrokenLines brokenLines(const Source& source, int line, const Limits& limits) {
  return Lines(source, limits).around(line);
}

std::string withoutLines(const Source& source, const BrokenLines& broken) {
  std::string text = source.text();
  for (int number = broken.first; number <= broken.last; ++number) {
    const std::string_view line = source.line(number);
    if (line.empty()) continue;
    const auto begin = static_cast<std::size_t>(line.data() - source.text().data());
    std::fill_n(text.begin() + static_cast<std::ptrdiff_t>(begin), line.size(), ' ');
  }
  return text;
}

}  // namespace poinsot::scene
