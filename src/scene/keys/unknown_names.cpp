// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/unknown_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "core/text.h"
#include "scene/keys/carried_value.h"
#include "scene/keys/foreign_names.h"
#include "scene/keys/key_text.h"
#include "scene/keys/unknown_key.h"
#include "scene/shapes.h"

namespace poinsot::scene {
namespace {

// Number of names for which an example is made. A report shows no more problems than this.
constexpr std::size_t kMostExamples = 50;

/// Key for which unknown names of one table stand, with lines to paste.
struct Counterpart {
  std::vector<std::string> names;  ///< names, without their table
  std::string key;                 ///< path of the key
  std::vector<KeyLine> lines;      ///< the key and its value, and other keys with their values
  std::string with;                ///< other keys that the key needs, as in ForeignNames::with
  std::string_view note{};
};

/// Returns other keys that a shape needs: "radius = "10 cm"; mass = 1" for "sphere".
std::string needsOf(std::string_view shape) {
  std::string with;
  for (const NamedShape& known : namedShapes())
    if (known.word == shape)
      for (const std::string_view name : known.ways.back())  // the way without a size, if there is one
        with += fmt::format(
            "{} = {}; ", name,
            name == "size" && known.extents == 2 ? "[0.3, 0.2]" : findKey(pathBelow("body", name))->example);
  return with + "mass = 1";
}

std::string needsOf(const std::string& key, const std::string& value, std::string_view with) {
  if (nameOf(key) != "shape" || value.size() < 2) return std::string(with);
  return needsOf(std::string_view(value).substr(1, value.size() - 2));
}

std::vector<KeyLine> parsedLines(std::string_view with) {
  std::vector<KeyLine> lines;
  while (!with.empty()) {
    const std::size_t end = std::min(with.find(';'), with.size()), equals = with.find('=');
    lines.push_back({std::string(core::trimmed(with.substr(0, equals))),
                     std::string(core::trimmed(with.substr(equals + 1, end - equals - 1)))});
    with.remove_prefix(std::min(end + 1, with.size()));
  }
  return lines;
}

/// Returns the value that an example shows if the given value does not fit: the example of the key.
std::vector<KeyLine> exampleOf(const Key& key) {
  const std::string_view value = key.example.empty() ? key.fallback : key.example;
  if (value.empty()) return {};
  return {{std::string(nameOf(key.path)), std::string(value)}};
}

class Report {
 public:
  Report(std::vector<UnknownName> names, Leaves& leaves, Problems& problems)
      : names_(std::move(names)), leaves_(leaves), problems_(problems) {
    std::ranges::stable_sort(names_, {},
                             [](const UnknownName& name) { return std::tie(name.place.line, name.place.column); });
    for (const UnknownName& name : names_) values_.emplace(name.path, name.value);
  }

  void run() {
    std::vector<std::pair<const UnknownName*, std::optional<Counterpart>>> found;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (taken_.contains(names_[i].path)) continue;
      auto counterpart = i < kMostExamples ? counterpartOf(names_[i].path, names_[i].value) : std::nullopt;
      if (counterpart) take(*counterpart, tableOf(names_[i].path));
      found.emplace_back(&names_[i], std::move(counterpart));
    }
    for (const auto& [name, counterpart] : found)
      if (counterpart)
        problems_.add(name->place, messageOf(*name, *counterpart));
      else
        problems_.addLater(name->place, [path = name->path] { return unknownKey(path); });
  }

  /// Returns advice for a value that stands in place of a table, or that does not suit its key.
  std::string adviceFor(const std::string& path, const Node& value) {
    const auto counterpart = carriedByRow(path, value);
    if (!counterpart) return "";
    leaves_.meant.insert(counterpart->key);
    return advice(path, value.place, *counterpart);
  }

 private:
  /// Marks the names of a counterpart as reported, and its key as meant.
  void take(const Counterpart& counterpart, std::string_view table) {
    for (const std::string& name : counterpart.names) taken_.insert(pathBelow(table, name));
    leaves_.meant.insert(counterpart.key);
  }

  std::optional<Counterpart> counterpartOf(const std::string& path, const Node* value) const {
    const std::string_view table = tableOf(path);
    if (value->as<Node::Table>()) return std::nullopt;
    const bool isForeign =
        table.find_first_of(".[") == std::string_view::npos && !isTableArray(table) && !misspelt("", table);
    if (nameOf(path).size() > kLongestName || !(isTable(table) || isForeign)) return std::nullopt;
    if (auto foreign = foreignCounterpart(path)) return foreign;
    if (auto shape = shapeCounterpart(path)) return shape;
    if (auto unit = unitCounterpart(path, *value)) return unit;
    return keyElsewhere(path, *value);
  }

  std::optional<Counterpart> foreignCounterpart(const std::string& path) const {
    const std::vector<const ForeignNames*> rows = plausibleRows(path);
    for (const ForeignNames* row : rows)
      if (auto counterpart = ofRow(
              *row, path, carriedLines(*row, *findKey(keyFor(*row, path)), valuesOf(*row, path), leaves_.limits)))
        return counterpart;
    if (rows.empty()) return std::nullopt;
    return ofRow(*rows[0], path, exampleOf(*findKey(keyFor(*rows[0], path))));
  }

  std::optional<Counterpart> carriedByRow(const std::string& path, const Node& value) const {
    for (const ForeignNames* row : plausibleRows(path)) {
      if (row->carry == Carry::kNothing) return ofRow(*row, path, exampleOf(*findKey(keyFor(*row, path))));
      if (row->carry == Carry::kValue)
        if (auto counterpart =
                ofRow(*row, path, carriedLines(*row, *findKey(keyFor(*row, path)), {&value}, leaves_.limits)))
          return counterpart;
    }
    return std::nullopt;
  }

  std::optional<Counterpart> ofRow(const ForeignNames& row, const std::string& path,
                                   std::vector<KeyLine> lines) const {
    if (lines.empty()) return std::nullopt;
    const std::string key = keyFor(row, path);
    std::string with = needsOf(key, lines[0].value, row.with);
    return Counterpart{presentNames(row, path), key, std::move(lines), std::move(with), row.note};
  }

  static bool takesSeveral(const ForeignNames& row) {
    return row.carry == Carry::kList || row.carry == Carry::kTensor || row.carry == Carry::kNothing;
  }

  std::vector<std::string> presentNames(const ForeignNames& row, const std::string& path) const {
    std::vector<std::string> names;
    if (takesSeveral(row))
      for (const std::string_view name : namesIn(row))
        if (valueOf(path, name)) names.emplace_back(name);
    if (names.empty()) names.emplace_back(nameOf(path));
    return names;
  }

  std::vector<const Node*> valuesOf(const ForeignNames& row, const std::string& path) const {
    std::vector<const Node*> values;
    if (!takesSeveral(row)) return {values_.at(path)};
    for (const std::string_view name : namesIn(row)) values.push_back(valueOf(path, name));
    return values;
  }

  /// Returns the value of another unknown name of the same table; null if there is none.
  const Node* valueOf(const std::string& path, std::string_view name) const {
    const std::string sibling = pathBelow(tableOf(path), name);
    const auto found = values_.find(sibling);
    return found == values_.end() || taken_.contains(sibling) ? nullptr : found->second;
  }

  /// Returns the key body.shape for the name of a shape, such as "cylinder" or "cuboid".
  std::optional<Counterpart> shapeCounterpart(const std::string& path) const {
    const std::string name = core::lowered(nameOf(path));
    const std::string_view other = wordElsewhere(name), word = other.empty() ? std::string_view(name) : other;
    const std::vector<std::string_view> words = shapeWords();
    if (std::ranges::find(words, word) == words.end()) return std::nullopt;
    const ForeignNames row{"", "body.shape"};
    if (!isPlausible(row, path)) return std::nullopt;
    return ofRow(row, path, {{"shape", fmt::format("\"{}\"", word)}});
  }

  /// Returns the key of a name with a unit at its end, such as body.mass for body.mass_kg.
  std::optional<Counterpart> unitCounterpart(const std::string& path, const Node& value) const {
    for (std::size_t end = path.find('_', path.rfind('.') + 1); end != std::string::npos;
         end = path.find('_', end + 1)) {
      const std::string stem = path.substr(0, end), suffix = path.substr(end + 1);
      if (auto counterpart = withUnit(stem, suffix, value)) {
        counterpart->names = {std::string(nameOf(path))};
        return counterpart;
      }
    }
    return std::nullopt;
  }

  std::optional<Counterpart> withUnit(const std::string& stem, const std::string& suffix,
                                      const Node& value) const {
    std::vector<ForeignNames> rows;
    const std::string own = findKey(stem) ? patternOf(stem) : "";
    if (!own.empty()) rows.push_back({"", own});
    for (const ForeignNames* row : plausibleRows(stem)) rows.push_back(*row);
    const std::string other = rows.empty() ? sameName(nameOf(stem)).value_or("") : "";
    if (!other.empty()) rows.push_back({"", other});
    for (ForeignNames& row : rows) {
      const Key& key = *findKey(row.key);
      const std::string unit = unitInName(suffix, key.dimension);
      if (unit.empty() || row.carry != Carry::kValue) continue;
      row.unit = unit;
      std::vector<KeyLine> lines = carriedLines(row, key, {&value}, leaves_.limits);
      return ofRow(row, stem, lines.empty() ? exampleOf(key) : std::move(lines));
    }
    return std::nullopt;
  }

  /// Returns a key with the name in another table. Its own table has no similar name.
  std::optional<Counterpart> keyElsewhere(const std::string& path, const Node& value) const {
    if (misspelt(tableOf(path), nameOf(path))) return std::nullopt;
    const auto other = otherKey(path);
    const Key* key = other ? findKey(*other) : nullptr;
    if (!key || key->path.find('[') != std::string::npos) return std::nullopt;
    const auto carried = carriedValue(*key, value, leaves_.limits);
    std::vector<KeyLine> lines = exampleOf(*key);
    if (carried) lines = {{std::string(nameOf(key->path)), *carried}};
    if (lines.empty()) return std::nullopt;
    return Counterpart{{std::string(nameOf(path))}, *other, std::move(lines), "", ""};
  }

  std::string messageOf(const UnknownName& unknown, const Counterpart& counterpart) {
    std::vector<std::string> names;
    for (const std::string& name : counterpart.names) names.push_back(core::printable(name));
    const std::string path = pathBelow(tableOf(unknown.path), core::joined(names, ", "));
    return fmt::format("{}: unknown key{}{}", core::printable(path), names.size() > 1 ? "s" : "",
                       advice(unknown.path, unknown.place, counterpart));
  }

  /// Returns the question for the key and the lines to paste, for the end of a message. An override has no lines.
  std::string advice(const std::string& path, const Place& place, const Counterpart& counterpart) {
    std::string text = fmt::format("; did you mean {}?", counterpart.key);
    if (!counterpart.note.empty()) text += fmt::format(" {}", counterpart.note);
    if (leaves_.values.contains(counterpart.key)) return text + " The scene gives it too.";
    if (!place.source->hasLines() || !offered_.insert(counterpart.key).second) return text;
    return text + pasted(path, counterpart);
  }

  std::string pasted(const std::string& path, const Counterpart& counterpart) {
    const std::string table(tableOf(counterpart.key));
    std::vector<KeyLine> lines = otherLines(counterpart, table);
    lines.insert(lines.end(), counterpart.lines.begin(), counterpart.lines.end());
    if (table == tableOf(path)) return " For example:" + textOf(lines, "");
    const std::string_view opening = lineOf(table);
    if (opened_.contains(table) || opening.starts_with(tableText(table)))
      return fmt::format(" For example, in {}:{}", tableText(table), textOf(lines, ""));
    if (!opening.empty() && !opening.starts_with('['))  // keys with dots, after which TOML allows no header
      return " For example, at the top of the file:" + textOf(lines, table + ".");
    if (!tableOf(path).empty() && table.starts_with(std::string(tableOf(path)) + "."))
      return " For example:" + textOf(lines, table.substr(tableOf(path).size() + 1) + ".");
    opened_.insert(table);
    return fmt::format(" For example, at the end of the file:\n    {}{}", tableText(table), textOf(lines, ""));
  }

  /// Returns the line that makes a table: a header such as "[motion]", or a key with dots. Empty if there is none.
  std::string_view lineOf(const std::string& table) const {
    const auto found = leaves_.tables.find(table);
    return found == leaves_.tables.end() ? "" : core::trimmed(found->second.source->line(found->second.line));
  }

  static std::string textOf(const std::vector<KeyLine>& lines, const std::string& prefix) {
    std::string text;
    for (const KeyLine& line : lines) text += fmt::format("\n    {}{} = {}", prefix, line.name, line.value);
    return text;
  }

  /// Returns lines for the other keys that a key needs and that the scene does not give in any way.
  std::vector<KeyLine> otherLines(const Counterpart& counterpart, const std::string& table) {
    std::vector<KeyLine> lines = parsedLines(counterpart.with);
    std::erase_if(lines, [&](const KeyLine& line) { return isGiven(table, line.name); });
    for (const KeyLine& line : lines) offered_.insert(pathBelow(table, line.name));
    return lines;
  }

  /// Returns whether the scene, or an earlier example, gives a key or another key instead of it.
  bool isGiven(const std::string& table, const std::string& name) const {
    using Names = std::vector<std::string_view>;
    static const std::vector<std::pair<Names, Names>> alternatives = {
        {{"mass"}, {"density"}},
        {{"density"}, {"mass"}},
        {{"shape"}, {"principal_moments", "inertia", "catalogue"}},
        {{"size"}, {"radius", "height", "length", "edge"}},
        {{"radius", "height", "length", "edge"}, {"size"}},
    };
    const auto known = [&](std::string_view one) {
      const std::string path = pathBelow(table, one);
      return leaves_.values.contains(path) || leaves_.meant.contains(path) || offered_.contains(path);
    };
    return known(name) || std::ranges::any_of(alternatives, [&](const auto& pair) {
             return std::ranges::find(pair.first, name) != pair.first.end() &&
                    std::ranges::any_of(pair.second, known);
           });
  }

  std::vector<UnknownName> names_;
  Leaves& leaves_;
  Problems& problems_;
  std::map<std::string, const Node*, std::less<>> values_;
  std::set<std::string, std::less<>> taken_;    ///< paths of names that an earlier message contains
  std::set<std::string, std::less<>> offered_;  ///< keys in earlier examples
  std::set<std::string, std::less<>> opened_;   ///< tables that earlier examples begin
};

}  // namespace

void reportUnknown(std::vector<UnknownName> names, Leaves& leaves, Problems& problems) {
  Report(std::move(names), leaves, problems).run();
}

std::string adviceFor(const std::string& path, const Node& value, Leaves& leaves) {
  Problems none;
  return Report({}, leaves, none).adviceFor(path, value);
}

}  // namespace poinsot::scene
