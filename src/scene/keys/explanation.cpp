// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/explanation.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/text.h"
#include "physics/catalogue.h"
#include "scene/keys/foreign_names.h"
#include "scene/keys/key_text.h"
#include "scene/keys/keys.h"
#include "scene/keys/unknown_key.h"
#include "scene/shapes.h"
#include "scene/state_quantity.h"

namespace poinsot::scene {
namespace {

using Explanations = std::vector<Explanation>;

std::string takes(const Key& key) {
  const bool inWords = key.type == ValueType::kWord || key.type == ValueType::kWords;  // typeText lists the words
  if (inWords && !key.wordList.empty())
    return fmt::format("{} of the {}", key.type == ValueType::kWord ? "one" : "an array", key.wordList);
  const std::string type = typeText(key), range = inWords ? "" : rangeText(key);
  if (!key.words.empty()) return inWords ? type : fmt::format("{} {}", quantityName(key.dimension), range);
  return range.empty() ? type : fmt::format("{}, {}", type, range);
}

std::string line(const Key& key, std::string_view value) {
  return fmt::format("{} = {}", nameOf(key.path), value);
}

Explanation ofKey(const Key& key) {
  Explanation explanation{key.path, std::string(key.help), {{"takes", takes(key)}}};
  if (key.dimension != Dimension::kNone)
    explanation.rows.push_back(
        {"units", fmt::format("{}; a bare number is in {}", someUnits(key.dimension), siUnit(key.dimension))});
  explanation.rows.push_back({"default", key.fallback.empty() ? "none" : std::string(key.fallback)});
  const std::string_view table = tableOf(key.path);
  explanation.rows.push_back(
      {"example", table.empty() ? line(key, key.example) : tableText(table) + '\n' + line(key, key.example)});
  return explanation;
}

/// Returns the paths of all tables that contain keys, in the order of the reference. Leaves out tables of a view
/// that repeat a table of the scene, such as view[].camera.
std::vector<std::string_view> tables() {
  std::vector<std::string_view> found;
  for (const Key& key : keys())
    if (!repeatsInView(key) && std::ranges::find(found, tableOf(key.path)) == found.end())
      found.push_back(tableOf(key.path));
  return found;
}

/// Returns the description of a table. For a drawn thing, this is the help text of its key "visible".
std::string storyOf(std::string_view table) {
  const Key* visible = findKey(std::string(table) + ".visible");
  return visible ? std::string(visible->help) : "a table of its own";
}

Explanation ofTable(std::string_view table) {
  Explanation explanation{tableText(table), "", {}};
  for (const Key& key : keys())
    if (tableOf(key.path) == table)
      explanation.rows.push_back({std::string(nameOf(key.path)), std::string(key.help)});
  for (const std::string_view other : tables())
    if (!other.empty() && tableOf(other) == table) explanation.rows.push_back({tableText(other), storyOf(other)});
  return explanation;
}

Explanation ofAllTables() {
  Explanation explanation{
      "tables", "The tables of a scene file. Explain a table to see its keys, or a key to see its details.", {}};
  for (const std::string_view table : tables()) {
    if (table.empty()) continue;
    std::string names;
    for (const std::string& name : namesBelow(table)) names += (names.empty() ? "" : ", ") + name;
    explanation.rows.push_back({tableText(table), names});
  }
  return explanation;
}

/// Returns "camera" for "[camera]", "body.part[].mass" for "body.part[3].mass".
std::string unbracketed(std::string_view word) {
  while (word.size() > 1 && word.starts_with('[') && word.ends_with(']')) word = word.substr(1, word.size() - 2);
  return patternOf(word);
}

/// Returns "body.part.mass" for "body.part[].mass".
std::string withoutBrackets(std::string path) {
  for (auto at = path.find("[]"); at != std::string::npos; at = path.find("[]")) path.erase(at, 2);
  return path;
}

Explanations ofPath(std::string_view word) {
  const std::string path = unbracketed(word);
  if (const Key* key = findKey(path)) return {ofKey(*key)};
  for (const Key& key : keys())
    if (withoutBrackets(key.path) == path) return {ofKey(key)};
  const std::string array = path + "[]";
  for (const std::string_view table : tables())
    if (!table.empty() && (table == path || table == array)) return {ofTable(table)};
  return {};
}

Explanations ofName(std::string_view word) {
  Explanations found;
  for (const std::string_view table : tables()) {
    const std::string_view path = table.ends_with("[]") ? table.substr(0, table.size() - 2) : table;
    if (nameOf(path) == word && path != word) found.push_back(ofTable(table));
  }
  for (const Key& key : keys())
    if (nameOf(key.path) == word && key.path != word && !repeatsInView(key)) found.push_back(ofKey(key));
  return found;
}

/// Explains values of keys that have an explanation of their own: shapes, bodies of the catalogue, quantities.
Explanations ofWord(std::string_view word) {
  Explanations found;
  for (const NamedShape& shape : namedShapes())
    if (shape.word == word)
      found.push_back(
          {fmt::format("shape = \"{}\"", word), std::string(shape.help), {{"keys", described(shape)}}});
  for (const physics::CatalogueBody& body : physics::catalogue())
    if (body.name == word)
      found.push_back({fmt::format("catalogue = \"{}\"", word), body.title, {{"numbers", body.source}}});
  for (const StateQuantity& quantity : stateQuantities())
    if (quantity.name == word)
      found.push_back({fmt::format("\"{}\", a quantity of plots and read-outs", word),
                       std::string(quantity.help),
                       {{"unit", std::string(unitText(quantity.unit))}}});
  return found;
}

Explanations ofUnit(std::string_view word) {
  Explanations found;
  for (const Dimension dimension : dimensions())
    if (const Quantity one = parseQuantity(fmt::format("1 {}", word), dimension); one.ok())
      found.push_back({fmt::format("{}, a unit of {}", core::printable(word), pluralName(dimension)),
                       fmt::format("1 {} is {:.15g} {}.", core::printable(word), one.value, siUnit(dimension)),
                       {{"units", someUnits(dimension)}}});
  // No key has the dimension of a force, so the loop above does not find units of force.
  if (const std::string value = unitValue(word); found.empty() && !value.empty())
    found.push_back({fmt::format("{}, a unit", word), fmt::format("1 {} is {}.", word, value), {}});
  return found;
}

Explanation ofQuantities() {
  Explanation explanation{"units",
                          "Units of numbers such as \"3 rpm\". A unit may also be a product of powers of the "
                          "names below, such as \"g/cm^3\". A bare number is in the first unit of its row.",
                          {}};
  for (const Dimension dimension : dimensions())
    explanation.rows.push_back(
        {std::string(pluralName(dimension)), fmt::format("{}: {}", siUnit(dimension), usualUnits(dimension))});
  return explanation;
}

Explanation ofUnitNames() {
  Explanation explanation{"names of units", std::string(unitRules()), {}};
  std::erase(explanation.help, '`');
  for (const UnitText& unit : unitTexts()) {
    std::string text = unit.value;
    if (!unit.prefixed.empty()) text += fmt::format("; with a prefix {}", unit.prefixed);
    if (!unit.also.empty()) text += fmt::format("; also {}", unit.also);
    explanation.rows.push_back({unit.symbol, std::move(text)});
  }
  return explanation;
}

/// Explains the keys that accept a word. For "dark", this is the key style.theme.
Explanations ofValue(std::string_view word) {
  Explanations found;
  for (const Key& key : keys())
    if (key.wordList.empty() && !repeatsInView(key) && std::ranges::find(key.words, word) != key.words.end())
      found.push_back({fmt::format("\"{}\", a value of {}", word, key.path), std::string(key.help), {}});
  return found;
}

std::vector<std::string> known() {
  std::vector<std::string> words;
  for (const Key& key : keys()) {
    words.push_back(key.path);
    words.emplace_back(nameOf(key.path));
  }
  for (const std::string_view table : tables()) words.emplace_back(table);
  for (const NamedShape& shape : namedShapes()) words.emplace_back(shape.word);
  for (const physics::CatalogueBody& body : physics::catalogue()) words.push_back(body.name);
  for (const StateQuantity& quantity : stateQuantities()) words.emplace_back(quantity.name);
  return words;
}

/// Returns the key for a name of a textbook, such as "support", or for the label of an arrow, such as "show.V";
/// empty if there is none.
std::string meantBy(std::string_view word) {
  if (word.empty() || word.size() > kLongestName || word.find_first_of("[]") != word.npos) return "";
  for (const ForeignNames* row : plausibleRows(word))
    if (!row->key.empty() && row->carry != Carry::kLaunch) return keyFor(*row, word);
  return "";
}

}  // namespace

std::vector<Explanation> explanationsOf(std::string_view word) {
  if (word.empty()) return {ofAllTables()};
  Explanations found = ofPath(word);
  if (word.find('.') == word.npos) {
    std::ranges::move(ofName(word), std::back_inserter(found));
    std::ranges::move(ofWord(word), std::back_inserter(found));
    if (found.empty()) found = ofValue(word);
    if (word == "units") found = {ofQuantities(), ofUnitNames()};
  } else if (found.empty() && nameOf(word) == "color") {
    found = {ofTable("style.colors")};  // this table contains the colours of all things
  }
  return found.empty() ? ofUnit(word) : found;
}

std::vector<Explanation> explain(std::string_view word, const std::vector<std::string>& otherWords) {
  Explanations found = explanationsOf(word);
  if (found.size() == 1 && found[0].title.starts_with("style.colors."))  // a body has a support, too
    if (const Key* key = findKey(meantBy(word)); key && key->path.starts_with("body."))
      found.push_back(ofKey(*key));
  if (!found.empty()) return found;
  if (const std::string key = meantBy(word); !key.empty())
    throw core::usageError(
        fmt::format("{}: no key, table, shape or quantity of a scene has this name; did you mean {}?",
                    core::printable(word), key));
  constexpr std::size_t kLongest = 64;  // characters; the edit distance of longer text takes too long
  std::vector<std::string> words = known();
  words.insert(words.end(), otherWords.begin(), otherWords.end());
  const auto near = word.size() > kLongest ? std::nullopt : core::closest(word, words);
  throw core::usageError(fmt::format("{}: no key, table, shape or quantity of a scene has this name{}",
                                     core::printable(word), near ? fmt::format("; did you mean {}?", *near) : ""));
}

}  // namespace poinsot::scene
