// SPDX-License-Identifier: Apache-2.0
#include "scene/document/syntax_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>

#include "core/text.h"
#include "scene/document/arithmetic.h"
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
  if (says("expected '=', saw") && line.find('{') != line.npos)
    return "not TOML: " + text + " (write several values in brackets: [1, 2, 3])";
  if (says("expected a comment or whitespace, saw ','"))
    return fmt::format("not TOML: {} ({})", text, withComma(line));
  if (says("expected a comment or whitespace, saw") || says("expected digit, saw") ||
      says("expected comma or closing ']', saw"))
    return "not TOML: " + text + " (write a number with a unit, or a fraction, in quotes: \"3 rpm\")";
  if (says("escape sequence"))
    return "not TOML: " + text + " (write mathematics in single quotes, which keep backslashes: '$\\omega$')";
  return "not TOML: " + text;
}

/// Value of a line "key = value", with the text before and behind it.
struct GivenValue {
  std::string before, value, behind;
};

/// Returns the parts of a line with a key and a value; the behind may be a comment. A colon counts as the equals
/// sign, as in YAML.
std::optional<GivenValue> givenValue(std::string_view line) {
  constexpr std::size_t kLongest = 200;
  const std::size_t equals = line.find_first_of("=:");
  if (line.size() > kLongest || equals == line.npos || isHeader(line) || core::trimmed(line).starts_with('#'))
    return std::nullopt;
  const std::string_view key = core::trimmed(line.substr(0, equals));
  if (key.empty() || key.find_first_of("\t\"'[]{}(),") != key.npos) return std::nullopt;
  std::string name(key);
  std::ranges::replace(name, ' ', '_');
  std::size_t comment = line.size();
  char quote = 0;
  for (std::size_t i = equals; i < line.size() && comment == line.size(); ++i) {
    if (quote ? line[i] == quote : line[i] == '"' || line[i] == '\'') quote = quote ? 0 : line[i];
    if (!quote && (line[i] == '#' || line.substr(i, 2) == "//")) comment = i;
  }
  std::string_view value = core::trimmed(line.substr(equals + 1, comment - equals - 1));
  while (value.ends_with(',') || value.ends_with(';')) value = core::trimmed(value.substr(0, value.size() - 1));
  return GivenValue{name + " = ", std::string(value), std::string(line.substr(comment))};
}

/// Returns a text without typographic quotes, which become straight ones.
std::string straight(std::string text) {
  for (const std::string_view quote : {"\u201c", "\u201d", "\u2018", "\u2019"})
    for (std::size_t at = text.find(quote); at != text.npos; at = text.find(quote))
      text.replace(at, quote.size(), "\"");
  return text;
}

bool isWordOrNumber(std::string_view text) {
  return !text.empty() && text.find_first_of("\"'[]{}()=#,;\\") == text.npos;
}

/// Returns a single value of an array or of a key in TOML: in quotes if it is neither a number nor a flag.
std::string inToml(std::string_view given) {
  const std::string text(core::trimmed(given)), small = core::lowered(text);
  if (small == "true" || small == "yes" || small == "on" || small == "ja") return "true";
  if (small == "false" || small == "no" || small == "off" || small == "nein" || small == "none" || small == "null")
    return "false";
  if (matches(text, R"([-+]?\d+(\.\d*)?([eE][-+]?\d+)?|[-+]?\.\d+)")) {
    std::string number = text;
    if (number.ends_with('.')) number += '0';
    if (const std::size_t point = number.find('.');
        point == 0 || (point == 1 && !std::isdigit(static_cast<unsigned char>(number[0]))))
      number.insert(point, "0");
    return number;
  }
  if (matches(text, R"(\d{3,}/\d{3,})")) return "\"" + text + "\"";  // a frame rate
  if (const auto value = arithmeticIn(text)) return fmt::format("{:.7g}", *value);
  std::smatch call;
  if (text.size() < 60 && std::regex_match(text, call, std::regex(R"((np\.|math\.)?(deg2rad|radians)\((.*)\))")))
    return "\"" + call[3].str() + " deg\"";
  return isWordOrNumber(text) ? "\"" + text + "\"" : text;
}

/// Returns the elements of an array in TOML, from text without its brackets.
std::string arrayInToml(std::string_view elements) {
  std::string array;
  while (true) {
    const std::size_t comma = std::min(elements.find(','), elements.size());
    std::string_view one = core::trimmed(elements.substr(0, comma));
    const bool several = matches(one, R"([-+\d.eE]+(\s+[-+\d.eE]+)+)");
    while (!one.empty()) {
      const std::size_t end = several ? std::min(one.find_first_of(" \t"), one.size()) : one.size();
      array += (array.empty() ? "" : ", ") + inToml(one.substr(0, end));
      one = core::trimmed(one.substr(end));
    }
    if (comma == elements.size()) return "[" + array + "]";
    elements.remove_prefix(comma + 1);
  }
}

/// Returns a line in TOML for a line that is not, if its mistake is one of: a decimal comma, a tuple, numbers
/// without brackets, text without quotes or with typographic quotes, a colon, a comma at the end. Otherwise empty.
std::string mendedLine(std::string_view line) {
  if (line.size() != beginOf(line).size()) return "";
  const std::string_view text = core::trimmed(line);
  for (const std::string_view mark : {"//", ";", "%", "--"})
    if (text.starts_with(mark)) return "# " + std::string(text.substr(mark.size()));
  std::smatch parts;
  const std::string begin = beginOf(line);
  if (std::regex_match(begin, parts, std::regex(R"(\s*([A-Za-z_]\w*)\s*:\s*(#.*)?)")))
    return "[" + parts[1].str() + "]";
  if (std::regex_match(begin, parts, std::regex(R"(\s*([A-Za-z_]\w*)\s+([-+\d."'\[][^=:]*))")))
    return mendedLine(parts[1].str() + " = " + parts[2].str());
  auto given = givenValue(straight(std::string(line)));
  if (!given) return "";
  std::string& value = given->value;
  if (std::regex_match(value, parts,
                       std::regex(R"((np\.|numpy\.)?(array|list|tuple|vec3|vector|Vector)\((.*)\))")))
    value = std::string(parts[3].str());
  if (std::regex_match(value, parts,
                       std::regex(R"(\[([^\]]*)\]\s*\*?\s*([A-Za-z][\w/^ ]*))"))) {  // a unit for all
    const std::string unit = parts[2].str();
    std::string elements = parts[1].str();
    for (std::size_t comma = elements.find(','); comma != elements.npos;
         comma = elements.find(',', comma + unit.size() + 2))
      elements.insert(comma, " " + unit);
    value = "[" + elements + " " + unit + "]";
  }
  if (value.starts_with('{') && value.ends_with('}') && value.find('=') == value.npos) {  // as in Mathematica
    std::ranges::replace(value, '{', '[');
    std::ranges::replace(value, '}', ']');
  }
  const bool parentheses = value.starts_with('(') && value.ends_with(')') && value.size() > 2;
  const bool brackets = value.starts_with('[') && value.ends_with(']') && value.find('[', 1) == value.npos;
  if (matches(value, R"([-+]?\d+,\d+)"))
    std::ranges::replace(value, ',', '.');
  else if (parentheses || brackets)
    value = arrayInToml(std::string_view(value).substr(1, value.size() - 2));
  else if (value.find(',') != value.npos && value.find_first_of("\"'[]{}()") == value.npos)
    value = arrayInToml(value);
  else if (value.find_first_of("\"'[]{}()") == value.npos)
    value = inToml(value);
  return given->before + value + (given->behind.starts_with('#') ? "  " + given->behind : "");
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
  SyntaxProblem problem{placeOf(source, line, column, description), messageOf(source, line, description)};
  const bool isValue = description.find("cannot redefine") == description.npos;
  if (isValue && !openArrayAtLine(source, limits, line)) problem.mended = mendedLine(source.line(line));
  return problem;
}

}  // namespace poinsot::scene
