// SPDX-License-Identifier: Apache-2.0
#include "scene/document/document.h"

#include <fmt/format.h>

#include <toml++/toml.h>

#include "core/text.h"
#include "scene/document/broken_lines.h"
#include "scene/document/syntax_problem.h"
#include "scene/document/text_limits.h"

namespace poinsot::scene {
namespace {

// Number of syntax errors after which the rest of a text is not checked.
constexpr int kMostSyntaxErrors = 10;

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

  // Returns the position of a value in the source. If the value has several lines, the position ends with the
  // first line, because an error message shows one line only.
  Place place(const toml::source_region& region) const {
    const bool oneLine = region.end.line == region.begin.line && region.end.column > region.begin.column;
    const std::string_view line = source_.line(static_cast<int>(region.begin.line));
    const auto end = oneLine ? region.end.column : static_cast<toml::source_index>(line.size()) + 1;
    if (region.begin.column > line.size() + 1)  // a mended line may be longer than that of the source
      return {&source_, static_cast<int>(region.begin.line), 1, 1};
    const auto length = end > region.begin.column ? end - region.begin.column : 1;
    return {&source_, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column),
            static_cast<int>(length)};
  }

  const Source& source_;
};

[[noreturn]] void refuse(const Place& place, std::string message) {
  Problems problems;
  problems.add(place, std::move(message));
  problems.throwIfAny();
  throw std::logic_error("unreachable");
}

SyntaxProblem problemOf(const toml::parse_error& error, const Source& source, const Limits& limits) {
  const toml::source_position at = error.source().begin;
  return syntaxProblem(source, static_cast<int>(at.line), static_cast<int>(at.column), error.description(),
                       limits);
}

/// Returns whether a line is valid TOML by itself.
bool isToml(const std::string& line) {
  if (line.empty()) return false;
  if (line.starts_with('#')) return true;
  try {
    return !toml::parse(std::string_view(line)).empty();
  } catch (const toml::parse_error&) {
    return false;
  }
}

/// Returns the text of a source with another text in place of one line.
std::string withLine(const Source& source, int number, const std::string& line) {
  std::string text = source.text();
  const std::string_view old = source.line(number);
  return text.replace(static_cast<std::size_t>(old.data() - source.text().data()), old.size(), line);
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
    const SyntaxProblem problem = problemOf(error, source, limits);
    refuse(problem.place, problem.message);
  }
}

PartialDocument parseValidParts(const Source& source, const Limits& limits, Problems& problems) {
  if (const auto limit = exceededLimit(source, limits)) refuse(limit->place, limit->message);
  PartialDocument partial{{Node::Table(), {&source, 0, 0, 1}}};
  std::string text = source.text();
  for (int errors = 0; errors < kMostSyntaxErrors; ++errors) {
    const Source rest(source.name(), text);
    if (exceededLimit(rest, limits)) break;  // without some lines, others may change their meaning
    try {
      partial.root = Converter(source).node(toml::parse(std::string_view(text)));
      return partial;
    } catch (const toml::parse_error& error) {
      SyntaxProblem problem = problemOf(error, rest, limits);
      const BrokenLines broken = brokenLines(rest, problem.place.line, limits);
      problem.place.source = &source;
      const bool mends = broken.first == broken.last && isToml(problem.mended);
      if (mends) problem.message += ". For example:\n    " + core::printable(problem.mended);
      problems.add(problem.place, problem.message);
      if (!mends) partial.broken.insert(broken.table);
      text = mends ? withLine(rest, broken.first, problem.mended) : withoutLines(rest, broken);
      if (text == rest.text()) break;
    }
  }
  partial.broken.insert("");
  return partial;
}

std::string tomlText(const Node& node) {
  if (const auto* text = node.as<std::string>()) return tomlString(*text);
  if (const auto* array = node.as<Node::Array>()) {
    std::vector<std::string> parts;
    for (const Node& element : *array) parts.push_back(tomlText(element));
    return fmt::format("[{}]", core::joined(parts, ", "));
  }
  if (const auto* table = node.as<Node::Table>()) {
    std::vector<std::string> parts;
    for (const Entry& entry : *table) parts.push_back(tomlString(entry.key) + " = " + tomlText(entry.value));
    return fmt::format("{{{}}}", core::joined(parts, ", "));
  }
  return describe(node);
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
