// SPDX-License-Identifier: Apache-2.0
#include "scene/unit_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/text.h"

namespace poinsot::scene {
namespace {

using Names = std::vector<NamedUnit>;

void addPrefixed(Names& names, const UnitRow& row, const Prefix& prefix) {
  const Unit unit{prefix.factor * row.unit.factor, row.unit.exponents};
  for (const std::string_view symbol : wordsIn(prefix.symbols))
    names.push_back({fmt::format("{}{}", symbol, wordsIn(row.symbols).front()), unit, symbol});
  for (const std::string_view noun : wordsIn(row.nouns))
    for (const char* ending : {"", "s"})
      names.push_back({fmt::format("{}{}{}", prefix.name, noun, ending), unit, prefix.name});
}

void addRow(Names& names, const UnitRow& row) {
  for (const std::string_view symbol : wordsIn(row.symbols)) names.push_back({std::string(symbol), row.unit, ""});
  for (const std::string_view noun : wordsIn(row.nouns))
    for (const char* ending : {"", "s"}) names.push_back({fmt::format("{}{}", noun, ending), row.unit, ""});
  for (const Prefix& prefix : prefixesOf(row)) addPrefixed(names, row, prefix);
}

Names expandedTable() {
  Names names;
  for (const UnitRow& row : kUnits) addRow(names, row);
  return names;
}

/// Returns whether a prefix has another meaning in the other case. In the table, these are m and M. The prefix p
/// counts too, because the SI also has P (peta).
bool caseMatters(std::string_view prefix) { return prefix == "m" || prefix == "M" || prefix == "p"; }

bool keepsPrefix(const NamedUnit& known, std::string_view name) {
  return !caseMatters(known.prefix) || name.starts_with(known.prefix);
}

}  // namespace

const std::vector<NamedUnit>& namedUnits() {
  static const Names names = expandedTable();
  return names;
}

std::vector<std::string_view> wordsIn(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0) words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

std::vector<Prefix> prefixesOf(const UnitRow& row) {
  std::vector<Prefix> taken;
  for (const Prefix& prefix : kPrefixes)
    if (row.prefixes.find(prefix.symbols[0]) != std::string_view::npos) taken.push_back(prefix);
  return taken;
}

std::optional<Unit> unitNamed(std::string_view name) {
  static const auto index = [] {
    std::map<std::string_view, Unit> byName;
    for (const NamedUnit& known : namedUnits()) byName.emplace(known.name, known.unit);
    return byName;
  }();
  const auto found = index.find(name);
  return found == index.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::string> recased(std::string_view name) {
  const std::string small = core::lowered(name);
  const NamedUnit* meant = nullptr;
  for (const NamedUnit& known : namedUnits()) {
    if (core::lowered(known.name) != small) continue;
    if (!keepsPrefix(known, name)) return std::nullopt;
    if (meant && (meant->unit.factor != known.unit.factor || meant->unit.exponents != known.unit.exponents))
      return std::nullopt;
    if (!meant) meant = &known;
  }
  return meant ? std::optional(meant->name) : std::nullopt;
}

}  // namespace poinsot::scene
