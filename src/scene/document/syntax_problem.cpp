// SPDX-License-Identifier: Apache-2.0
#include "scene/document/syntax_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <regex>

#include "core/text.h"
#include "scene/document/text_limits.h"

namespace poinsot::scene {
namespace {

/// Returns the beginning of a line. std::regex uses recursion, so a long line could exhaust the stack.
std::string beginOf(std::string_view line) { return std::string(line.substr(0, 200)); }

bool matches(std::string_view line, const char* pattern) {
  return std::regex_match(beginOf(line), std::regex(pattern));
}

std::string_view quotedIn(std::string_view text) {
  const std::size_t open = text.find('\''), close = text.rfind('\'');
  return open == std::string_view::npos || close <= open + 1 ? "" : text.substr(open + 1, close - open - 1);
}

/// Returns the position of the rejected word, which toml++ quotes. toml++ reports the position after the word.
Place placeOf(const Source& source, int lineNumber, int column, std::string_view description) {
  Place place{&source, lineNumber, column, 1};
  const std::string_view word = quotedIn(description);
  if (word.empty() || description.find("saw '") != std::string_view::npos) return place;
  const std::string_view line = source.line(lineNumber).substr(0, static_cast<std::size_t>(column));
  const std::size_t found = line.rfind(word);
  if (found == std::string_view::npos) return place;
  place.column = static_cast<int>(characterCount(line.substr(0, found))) + 1;
  place.length = static_cast<int>(characterCount(word));
  return place;
}

std::string continued(std::string text) { return text.replace(0, 1, core::lowered(text.substr(0, 1))); }

bool isHeader(std::string_view line) { return core::trimmed(line).starts_with('['); }

/// Returns the name that a line defines: for a header such as [[body.part]] the path in the brackets, otherwise
/// the key before the equals sign. Empty for other lines. Does not use the slow std::regex, because it runs for
/// every line.
std::string_view givenBy(std::string_view line) {
  const std::size_t equals = line.find('='), path = std::min(line.find_first_not_of(" \t["), line.size());
  if (!isHeader(line)) return equals == line.npos ? "" : core::trimmed(line.substr(0, equals));
  return core::trimmed(line.substr(path, line.find(']') - path));
}

/// Returns an earlier line that defines the same key or header. Looks for a key only in its own table.
std::optional<int> givenBefore(const Source& source, int lineNumber) {
  const bool header = isHeader(source.line(lineNumber));
  const std::string_view given = givenBy(source.line(lineNumber));
  if (given.empty()) return std::nullopt;
  for (int above = lineNumber - 1; above > 0; --above) {
    const bool other = isHeader(source.line(above)) != header;
    if (!other && givenBy(source.line(above)) == given) return above;
    if (other && !header) return std::nullopt;
  }
  return std::nullopt;
}

std::string twice(const Source& source, int lineNumber, std::string_view text) {
  if (text.find("cannot redefine existing boolean") != text.npos)
    return "already given as true or false; remove that line, because the keys of this table make the thing "
           "visible";
  const auto before = givenBefore(source, lineNumber);
  const std::string_view name = givenBy(source.line(lineNumber));
  if (before && text.find("as array-of-tables") != text.npos)
    return fmt::format("line {} has single brackets; each element of an array of tables begins with [[{}]]",
                       *before, core::printable(name));
  const std::string where = before ? fmt::format("; first on line {}", *before) : "";
  return fmt::format("this key or table is given twice: {}{}", text, where);
}

std::string withComma(std::string_view line) {
  return matches(line, R"([^=]*=\s*[-+]?\d+,\d+\s*(#.*)?)") ? "write decimals with a point: 9.81"
                                                            : "write several values in brackets: [1, 2, 3]";
}

std::string messageOf(const Source& source, int lineNumber, std::string_view description) {
  const std::string_view line = source.line(lineNumber);
  const bool typographic = line.find("\u201c") != line.npos || line.find("\u201d") != line.npos ||
                           line.find("\u2018") != line.npos || line.find("\u2019") != line.npos;
  const std::string text = continued(core::printable(description));
  const auto says = [&](std::string_view part) { return text.find(part) != std::string::npos; };
  if (says("cannot redefine")) return twice(source, lineNumber, text);
  if (says("parsing string") && (says("control characters") || says("end-of-file")))
    return "not TOML: this text has no closing quote";
  if (says("could not determine value type") || says("parsing boolean"))
    return typographic ? "not a TOML value; write text in straight quotes: \"...\" or '...'"
                       : "not a TOML value; write text in quotes: \"...\"";
  if (says("could not be interpreted as a value") || says("is not representable"))
    return "a number out of range: " + text;
  if (says("expected a comment or whitespace, saw ','"))
    return fmt::format("not TOML: {} ({})", text, withComma(line));
  if (says("expected a comment or whitespace, saw") || says("expected digit, saw") ||
      says("expected comma or closing ']', saw"))
    return "not TOML: " + text + " (write a number with a unit, or a fraction, in quotes: \"3 rpm\")";
  if (says("escape sequence"))
    return "not TOML: " + text + " (write mathematics in single quotes, which keep backslashes: '$\\omega$')";
  return "not TOML: " + text;
}

/// Returns whether a line begins a table or defines a key. No line inside an array does so.
bool beginsAnew(std::string_view line) {
  return matches(line, R"(\s*(\[{1,2}\s*[A-Za-z][\w.\s]*\]|[\w.\s-]+=).*)");
}

/// Returns the position of the opening bracket if an array has no closing bracket. toml++ reports such an error
/// only where the next key begins, often several lines below.
std::optional<Place> unclosedArray(const Source& source, int line, std::string_view description,
                                   const Limits& limits) {
  const bool atEnd = description.find("encountered end-of-file") != std::string_view::npos;
  if (!atEnd && !beginsAnew(source.line(line))) return std::nullopt;
  return openArrayAtLine(source, limits, atEnd ? line + 1 : line);
}

}  // namespace

SyntaxProblem syntaxProblem(const Source& source, int line, int column, std::string_view description,
                            const Limits& limits) {
  if (const auto bracket = unclosedArray(source, line, description, limits))
    return {*bracket, "not TOML: the array that begins here has no closing ]"};
  return {placeOf(source, line, column, description), messageOf(source, line, description)};
}

}  // namespace poinsot::scene
