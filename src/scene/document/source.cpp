// SPDX-License-Identifier: Apache-2.0
#include "scene/document/source.h"

#include <algorithm>
#include <tuple>

#include "core/text.h"

namespace poinsot::scene {
namespace {

// Number of problems that are reported, about a screenful. A file may contain a hundred thousand.
constexpr std::size_t kMostReported = 50;
// Number of characters of the longest line that a message shows completely. Of a longer line, it shows a part that
// begins kShownBefore characters before the error.
constexpr std::size_t kLongestLine = 120;
constexpr std::size_t kShownBefore = 60;

bool startsCharacter(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

/// Returns the characters [first, first + count) of UTF-8 text. The count may be wrong for invalid UTF-8.
std::string_view characters(std::string_view text, std::size_t first, std::size_t count) {
  std::size_t begin = text.size(), end = text.size(), index = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!startsCharacter(text[i])) continue;
    if (index == first) begin = i;
    if (index == first + count) end = i;
    ++index;
  }
  return text.substr(begin, end - begin);
}

std::string withoutTabs(std::string_view text) {
  std::string copy(text);
  std::replace(copy.begin(), copy.end(), '\t', ' ');
  return core::printable(copy);
}

int columnsOf(const std::string& safe) { return static_cast<int>(characterCount(safe)); }

void addExcerpt(Problem& problem, std::string_view line, const Place& place) {
  const auto column = static_cast<std::size_t>(std::max(place.column, 1)) - 1;
  const bool cut = characterCount(line) > kLongestLine;
  const std::size_t first = cut && column > kShownBefore ? column - kShownBefore : 0;
  const std::size_t shown = std::min(cut ? kLongestLine : line.size(), kLongestLine);
  const std::size_t marked =
      std::min(static_cast<std::size_t>(place.length), shown - std::min(shown, column - first));
  problem.sourceLine = withoutTabs(characters(line, first, shown));
  problem.caret = columnsOf(withoutTabs(characters(line, first, column - first)));
  problem.caretLength = std::max(columnsOf(withoutTabs(characters(line, column, marked))), 1);
}

Problem toProblem(const Place& place, std::string message) {
  Problem problem;
  problem.where = locationOf(place);
  problem.message = std::move(message);
  if (!place.source->hasLines()) return problem;
  if (const std::string_view line = place.source->line(place.line); !line.empty())
    addExcerpt(problem, line, place);
  return problem;
}

}  // namespace

std::size_t characterCount(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), startsCharacter));
}

core::SourceLocation locationOf(const Place& place) {
  const std::string file = core::printable(place.source->name());
  if (!place.source->hasLines()) return {file, 0, 0};
  return {file, std::max(place.line, 1), std::max(place.column, 1)};
}

Source::Source(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
  lineStarts_.push_back(text_.starts_with("\xef\xbb\xbf") ? 3 : 0);  // line 1 begins after a byte order mark
  for (std::size_t i = 0; i < text_.size(); ++i)
    if (text_[i] == '\n') lineStarts_.push_back(i + 1);
}

std::string_view Source::line(int number) const {
  if (number < 1 || static_cast<std::size_t>(number) > lineStarts_.size()) return {};
  const std::size_t begin = lineStarts_[static_cast<std::size_t>(number) - 1];
  std::string_view line = std::string_view(text_).substr(begin);
  line = line.substr(0, line.find('\n'));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

void Problems::add(const Place& place, std::string message) { found_.push_back({place, std::move(message)}); }

void Problems::addLater(const Place& place, std::function<std::string()> message) {
  found_.push_back({place, "", std::move(message)});
}

void Problems::throwIfAny() {
  if (found_.empty()) return;
  const auto order = [](const Found& f) {
    return std::tuple(!f.place.source->hasLines(), f.place.line, f.place.column);
  };
  std::stable_sort(found_.begin(), found_.end(),
                   [&](const Found& a, const Found& b) { return order(a) < order(b); });
  std::vector<Problem> problems;
  std::size_t read = 0;
  for (; read < found_.size() && problems.size() < kMostReported; ++read) {
    Found& found = found_[read];
    Problem problem = toProblem(found.place, found.make ? found.make() : std::move(found.message));
    // Equal problems are reported once. In a source without lines, all elements of a value have the same position.
    const auto isSame = [&](const Problem& earlier) { return toString(earlier) == toString(problem); };
    if (std::ranges::none_of(problems, isSame)) problems.push_back(std::move(problem));
  }
  throw SceneErrors(std::move(problems), static_cast<int>(found_.size() - read));
}

}  // namespace poinsot::scene
