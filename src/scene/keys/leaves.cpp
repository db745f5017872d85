// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/leaves.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "core/text.h"
#include "scene/keys/carried_value.h"
#include "scene/keys/foreign_names.h"
#include "scene/keys/unknown_key.h"
#include "scene/keys/unknown_names.h"
#include "scene/limits.h"

namespace poinsot::scene {
namespace {

constexpr std::size_t kMostUnknown = 20;  // stored names per table; a suggestion compares each with all keys

/// Returns the path of the array of tables: "body.part" for "body.part[3].mass".
std::string_view arrayOf(std::string_view path) { return path.substr(0, path.find('[')); }

class Walk {
 public:
  Walk(Leaves& leaves, Problems& problems) : leaves_(leaves), problems_(problems) {}

  void table(std::string_view path, const Node::Table& entries) {
    for (const Entry& entry : entries) {
      const bool noName = entry.key.empty() || entry.key.find_first_of(".[]") != std::string::npos;
      if (noName)  // a quoted key with a dot, such as "a.b", is not a path
        problems_.add(entry.keyPlace, fmt::format("\"{}\": unknown key", core::printable(entry.key)));
      else
        value(pathBelow(path, entry.key), entry.keyPlace, entry.value);
    }
  }

  /// Reports the unknown names and the values that stand in place of tables, after all others are known.
  void finish() { reportUnknown(std::move(unknown_), leaves_, problems_); }

  void value(const std::string& path, const Place& keyPlace, const Node& node) {
    if (path.find('[') != std::string::npos && !exists(path))
      problems_.addLater(keyPlace,
                         [path, count = leaves_.count(arrayOf(path))] { return noElement(path, count); });
    else if (findKey(path))
      leaves_.values[path] = node;
    else if (isTableArray(path))
      array(path, node);
    else if (!isTable(path))
      unknownNames(path, keyPlace, node);
    else if (const auto* entries = node.as<Node::Table>())
      opened(path, keyPlace, *entries);
    else if (node.as<bool>() && hasVisible(path))
      leaves_.values[path + ".visible"] = node;
    else if (node.as<std::string>() && findKey(pathBelow(path, "preset")))
      leaves_.values[pathBelow(path, "preset")] = node;
    else
      noTable(path, node);
  }

 private:
  /// Takes the keys of a table of another program, such as [simulation], as unknown names, if the table stands for
  /// one of this program or one of its names leads to a key. Otherwise, the table itself is the unknown name.
  void unknownNames(const std::string& path, const Place& place, const Node& node) {
    const auto* entries = node.as<Node::Table>();
    const auto leads = [&](const Entry& entry) {
      return !entry.value.as<Node::Table>() && !plausibleRows(pathBelow(path, entry.key)).empty();
    };
    std::string alias = entries && !entries->empty() ? tableElsewhere(nameOf(path)) : "";
    if (!tableOf(path).empty() && !alias.starts_with(std::string(tableOf(path)) + ".")) alias.clear();
    const bool isMisspelt = alias.empty() && misspelt(tableOf(path), nameOf(path));
    if (!entries || isMisspelt || becomesValue(path, place, node)) return unknown(path, place, node);
    if (!alias.empty())
      leaves_.aliases[path] = alias;
    else if (!tableOf(path).empty() && isTable(tableOf(path)) && std::ranges::any_of(*entries, fitsParent(path)))
      leaves_.aliases[path] = std::string(tableOf(path));  // [motion.initial] stands for [motion]
    else if (std::ranges::none_of(*entries, leads))
      return unknown(path, place, node);
    table(path, *entries);
  }

  static std::function<bool(const Entry&)> fitsParent(const std::string& path) {
    return [parent = std::string(tableOf(path))](const Entry& entry) {
      const std::string own = pathBelow(parent, entry.key);
      return findKey(own) || !plausibleRows(own).empty();
    };
  }

  /// Returns whether a table on one line stands for one value, such as { x = 1, y = 2, z = 3 } for a vector.
  bool becomesValue(const std::string& path, const Place& place, const Node& node) const {
    if (core::trimmed(place.source->line(place.line)).starts_with('[')) return false;
    return std::ranges::any_of(plausibleRows(path), [&](const ForeignNames* row) {
      if (row->carry == Carry::kEuler) return true;
      const Key* key = row->carry == Carry::kValue || row->carry == Carry::kReversed ? findKey(row->key) : nullptr;
      return key && carriedValue(*key, node, leaves_.limits);
    });
  }

  void unknown(const std::string& path, const Place& place, const Node& node) {
    remember(path);
    unknown_.push_back({path, place, &node});
  }

  void noTable(const std::string& path, const Node& node) {
    remember(path);
    unknown_.push_back({path, node.place, &node, true});
  }

  void wrongForm(const std::string& path, const Place& place, std::string message) {
    remember(path);
    if (leaves_.broken.contains(path)) return;  // a syntax error of this table is already reported
    problems_.add(place, std::move(message));
  }

  void remember(const std::string& path) {
    std::vector<std::string>& names = leaves_.unknown[std::string(tableOf(path))];
    if (names.size() < kMostUnknown) names.emplace_back(nameOf(path));
  }

  void opened(const std::string& path, const Place& place, const Node::Table& entries) {
    leaves_.tables[path] = place;
    table(path, entries);
  }

  /// Returns whether the scene has the element that a path contains, such as "body.part[3]".
  bool exists(std::string_view path) const {
    const std::size_t end = path.find(']');
    return end != std::string_view::npos && leaves_.tables.contains(path.substr(0, end + 1));
  }

  static std::string noElement(const std::string& path, std::size_t count) {
    const std::string array(arrayOf(path));
    if (!isTableArray(array)) return unknownKey(path);
    if (path.find("[]") != std::string::npos) return withoutIndex(path, array);
    return fmt::format("{}: there is no such element; the scene has {} of [[{}]], counted from 0",
                       core::printable(path), count, array);
  }

  void array(const std::string& path, const Node& node) {
    const auto* elements = node.as<Node::Array>();
    if (node.as<Node::Table>()) return singleTable(path, node);
    if (!elements || !areTables(*elements))
      return wrongForm(path, node.place,
                       fmt::format("{}: expected an array of tables, each begun with [[{}]], got {}", path, path,
                                   describe(node)));
    if (const auto most = leaves_.limits[Limit::kElements]; elements->size() > static_cast<std::size_t>(most))
      return problems_.add(node.place, fmt::format("{}: may have at most {} elements, got {}; {}", path, most,
                                                   elements->size(), howToRaise(Limit::kElements)));
    forget(path);
    leaves_.counts[path] = elements->size();
    for (std::size_t i = 0; i < elements->size(); ++i)
      opened(fmt::format("{}[{}]", path, i), (*elements)[i].place, *(*elements)[i].as<Node::Table>());
  }

  /// Reports a table with single brackets, and takes it as the only element of the array.
  void singleTable(const std::string& path, const Node& node) {
    if (node.place.source->hasLines())
      wrongForm(
          path, node.place,
          fmt::format("{0}: expected an array of tables, each begun with [[{0}]], got a table. For example, in "
                      "place of [{0}]:\n    [[{0}]]",
                      path));
    else
      wrongForm(path, node.place,
                fmt::format("{0}: expected an array of tables, each begun with [[{0}]], got a table", path));
    forget(path);
    leaves_.counts[path] = 1;
    opened(path + "[0]", node.place, *node.as<Node::Table>());
  }

  static bool areTables(const Node::Array& elements) {
    return std::all_of(elements.begin(), elements.end(),
                       [](const Node& element) { return element.as<Node::Table>() != nullptr; });
  }

  /// Removes the elements of an array of tables, before the values of a new array replace them.
  void forget(const std::string& array) {
    const auto isBelow = [prefix = array + "["](const auto& entry) { return entry.first.starts_with(prefix); };
    std::erase_if(leaves_.values, isBelow);
    std::erase_if(leaves_.tables, isBelow);
  }

  Leaves& leaves_;
  Problems& problems_;
  std::vector<UnknownName> unknown_;
};

}  // namespace

void addLeaves(const Node& document, Leaves& leaves, Problems& problems) {
  const auto* entries = document.as<Node::Table>();
  if (!entries) return;
  Walk walk(leaves, problems);
  walk.table("", *entries);
  walk.finish();
}

void addLeaf(const std::string& path, const Place& keyPlace, const Node& value, Leaves& leaves,
             Problems& problems) {
  Walk walk(leaves, problems);
  walk.value(path, keyPlace, value);
  walk.finish();
}

}  // namespace poinsot::scene
