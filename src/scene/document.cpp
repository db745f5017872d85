// SPDX-License-Identifier: Apache-2.0
#include "scene/document.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <toml++/toml.h>
#include <algorithm>
#include <regex>

#include "core/text.h"
#include "scene/text_limits.h"

namespace poinsot::scene {
namespace {

class Converter {
 public:
  explicit Converter(const Source& source) : source_(source) {}

  Node node(const toml::node& from) const {
    Node to;
    to.place = place(from.source());
    if (const auto* table = from.as_table()) to.value = entries(*table);
    if (const auto* array = from.as_array()) to.value = elements(*array);
    if (const auto* flag = from.as_boolean()) to.value = flag->get();
    if (const auto* integer = from.as_integer()) to.value = integer->get();
    if (const auto* number = from.as_floating_point()) to.value = number->get();
    if (const auto* text = from.as_string()) to.value = text->get();
    if (from.is_date() || from.is_time() || from.is_date_time()) to.value = DateOrTime{};
    return to;
  }

 private:
  Node::Table entries(const toml::table& table) const {
    Node::Table to;
    for (auto&& [key, value] : table) to.push_back({std::string(key.str()), place(key.source()), node(value)});
    return to;
  }

  Node::Array elements(const toml::array& array) const {
    Node::Array to;
    to.reserve(array.size());
    for (const toml::node& element : array) to.push_back(node(element));
    return to;
  }

  // What spans lines is marked to the end of its first one; the excerpt stops there.
  Place place(const toml::source_region& region) const {
    const bool oneLine = region.end.line == region.begin.line && region.end.column > region.begin.column;
    const std::string_view line = source_.line(static_cast<int>(region.begin.line));
    const auto end = oneLine ? region.end.column : static_cast<toml::source_index>(line.size()) + 1;
    const auto length = end > region.begin.column ? end - region.begin.column : 1;
    return {&source_, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column),
            static_cast<int>(length)};
  }

  const Source& source_;
};

/// toml++ stops after the word it refuses and quotes it; this is where the word begins.
Place placeOf(const toml::parse_error& error, const Source& source) {
  const toml::source_position at = error.source().begin;
  Place place{&source, static_cast<int>(at.line), static_cast<int>(at.column), 1};
  const std::string_view text = error.description();
  const bool quotesWhatItRead = text.find("saw '") == std::string_view::npos;
  const std::size_t open = text.find('\''), close = text.rfind('\'');
  if (!quotesWhatItRead || open == std::string_view::npos || close <= open + 1) return place;
  const std::string_view word = text.substr(open + 1, close - open - 1);
  const std::string_view line = source.line(place.line).substr(0, at.column);
  const std::size_t found = line.rfind(word);
  if (found == std::string_view::npos) return place;
  place.column = static_cast<int>(characterCount(line.substr(0, found))) + 1;
  place.length = static_cast<int>(characterCount(word));
  return place;
}

std::string lowered(std::string text) {
  if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] - 'A' + 'a');
  return text;
}

/// In the words of someone who writes scenes, with the usual slip named.
std::string messageOf(const toml::parse_error& error, std::string_view line) {
  const bool typographic = line.find("\u201c") != line.npos || line.find("\u201d") != line.npos ||
                           line.find("\u2018") != line.npos || line.find("\u2019") != line.npos;
  const std::string text = lowered(core::printable(error.description()));
  const auto says = [&](std::string_view part) { return text.find(part) != std::string::npos; };
  if (says("cannot redefine existing boolean"))
    return "given before as true or false; leave that line out: the keys below it ask for the thing";
  if (says("cannot redefine")) return "this key or table is given twice: " + text;
  if (says("parsing string") && (says("control characters") || says("end-of-file")))
    return "not TOML: this text has no closing quote";
  if (says("could not determine value type"))
    return typographic ? "not a TOML value; text stands in straight quotes: \"...\" or '...'"
                       : "not a TOML value; text stands in quotes: \"...\"";
  if (says("could not be interpreted as a value") || says("is not representable"))
    return "a number out of range: " + text;
  if (says("expected a comment or whitespace, saw") || says("expected digit, saw"))
    return "not TOML: " + text + " (a number with a unit, or a fraction, stands in quotes: \"3 rpm\")";
  if (says("escape sequence"))
    return "not TOML: " + text + " (mathematics stands in single quotes, where a backslash is one: '$\\omega$')";
  return "not TOML: " + text;
}

/// Whether the line begins a table or gives a key, which no line within an array does.
bool beginsAnew(std::string_view line) {
  const std::regex headerOrKey(R"(\s*(\[{1,2}\s*[A-Za-z][\w.\s]*\]|[\w.\s-]+=).*)");
  constexpr std::size_t kLongest = 200;  // of which the library's recursion has to know nothing
  return std::regex_match(std::string(line.substr(0, kLongest)), headerOrKey);
}

/// The bracket of an array that has no end: toml++ sees that only at what follows, often lines below.
std::optional<Place> unclosedArray(const toml::parse_error& error, const Source& source, const Limits& limits) {
  const int line = static_cast<int>(error.source().begin.line);
  const bool atEnd = error.description().find("encountered end-of-file") != std::string_view::npos;
  if (!atEnd && !beginsAnew(source.line(line))) return std::nullopt;
  return openArrayAtLine(source, limits, atEnd ? line + 1 : line);
}

[[noreturn]] void refuse(const Place& place, std::string message) {
  Problems problems;
  problems.add(place, std::move(message));
  problems.throwIfAny();
  throw std::logic_error("unreachable");
}

std::string tomlString(std::string_view text) {
  std::string all = "\"";
  for (const char c : text)
    if (c == '"' || c == '\\')
      all += {'\\', c};
    else if (static_cast<unsigned char>(c) < ' ' || c == 0x7f)
      all += fmt::format("\\u{:04X}", c);
    else
      all += c;
  return all + '"';
}

}  // namespace

Node parseDocument(const Source& source, const Limits& limits) {
  if (const auto limit = exceededLimit(source, limits)) refuse(limit->place, limit->message);
  try {
    return Converter(source).node(toml::parse(std::string_view(source.text())));
  } catch (const toml::parse_error& error) {
    if (const auto bracket = unclosedArray(error, source, limits))
      refuse(*bracket, "not TOML: the array that begins here has no closing ]");
    refuse(placeOf(error, source), messageOf(error, source.line(static_cast<int>(error.source().begin.line))));
  }
}

std::string tomlText(const Node& node) {
  if (const auto* text = node.as<std::string>()) return tomlString(*text);
  if (const auto* array = node.as<Node::Array>()) {
    std::vector<std::string> parts;
    for (const Node& element : *array) parts.push_back(tomlText(element));
    return fmt::format("[{}]", fmt::join(parts, ", "));
  }
  if (const auto* table = node.as<Node::Table>()) {
    std::vector<std::string> parts;
    for (const Entry& entry : *table) parts.push_back(tomlString(entry.key) + " = " + tomlText(entry.value));
    return fmt::format("{{{}}}", fmt::join(parts, ", "));
  }
  return describe(node);  // true, 3, 0.5
}

std::string describe(const Node& node) {
  if (const auto* flag = node.as<bool>()) return *flag ? "true" : "false";
  if (const auto* integer = node.as<std::int64_t>()) return fmt::format("{}", *integer);
  if (const auto* number = node.as<double>()) return fmt::format("{}", *number);
  if (const auto* text = node.as<std::string>()) return fmt::format("\"{}\"", core::printable(*text));
  if (const auto* array = node.as<Node::Array>()) return fmt::format("an array of {}", array->size());
  return node.as<Node::Table>() ? "a table" : "a date or time";
}

}  // namespace poinsot::scene
