// SPDX-License-Identifier: Apache-2.0
#include "scene/leaves.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/text.h"
#include "scene/key_text.h"
#include "scene/limits.h"

namespace poinsot::scene {
namespace {

// Longer than any name by far; the edit distance of untrusted kilobytes is not worth its time.
constexpr std::size_t kLongestName = 64;

std::optional<std::string> nameElsewhere(std::string_view name) {
  for (const Key& key : keys())
    if (nameOf(key.path) == name) return key.path;
  return std::nullopt;
}

/// A sibling that is spelled alike, else the same name in another table.
std::optional<std::string> meant(std::string_view path) {
  const std::string table(tableOf(path));
  const std::string_view name = nameOf(path);
  if (name.size() > kLongestName) return std::nullopt;
  if (const auto near = core::closest(name, namesBelow(table))) return table.empty() ? near : table + "." + *near;
  return nameElsewhere(name);
}

bool holdsKeys(std::string_view path) { return isTable(path) || isTableArray(path); }

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// The first part of a path that stands as a table and is none: "tim" of "tim.x".
std::optional<std::string_view> firstNoTable(std::string_view path) {
  for (std::size_t dot = path.find('.'); dot != std::string_view::npos; dot = path.find('.', dot + 1))
    if (!holdsKeys(path.substr(0, dot))) return path.substr(0, dot);
  return std::nullopt;
}

std::string below(std::string_view table, std::string_view name) {
  return table.empty() ? std::string(name) : fmt::format("{}.{}", table, name);
}

std::vector<std::string> tablesBelow(std::string_view table) {
  std::vector<std::string> tables = namesBelow(table);
  std::erase_if(tables, [&](const std::string& name) { return !holdsKeys(below(table, name)); });
  return tables;
}

/// What to write in place of a table that is none: the nearest one beside it, else a key of that name elsewhere.
std::string insteadOf(std::string_view table, std::string_view path) {
  const std::string_view parent = tableOf(table);
  const std::vector<std::string> tables = tablesBelow(parent);
  if (table.size() <= kLongestName)
    if (const auto near = core::closest(nameOf(table), tables))
      return fmt::format("did you mean {}?", tableText(below(parent, *near)));
  if (const auto key = nameElsewhere(nameOf(path))) return fmt::format("did you mean {}?", *key);
  return fmt::format("{} has the tables {}", parent.empty() ? "a scene" : fmt::format("[{}]", parent),
                     joined(tables));
}

std::string unknownTable(std::string_view path, std::string_view table) {
  const std::string shown = core::printable(path);
  if (const Key* key = findKey(table))
    return fmt::format("{}: unknown key; {} is {}, and has no keys below it", shown, table, typeText(*key));
  return fmt::format("{}: unknown table [{}]; {}", shown, core::printable(table), insteadOf(table, path));
}

/// What stands before the first index: "body.part" of "body.part[3].mass".
std::string_view arrayOf(std::string_view path) { return path.substr(0, path.find('[')); }

/// Of a path to a key of `array` without an index.
std::string unindexed(std::string_view path, std::string_view array) {
  return fmt::format("{}: [[{}]] is an array of tables; name one by its number from 0, such as {}[0]",
                     core::printable(path), array, array);
}

std::string unknownKey(std::string_view path) {
  if (const auto noTable = firstNoTable(path)) return unknownTable(path, *noTable);
  if (isTableArray(tableOf(path))) return unindexed(path, tableOf(path));
  const std::string message = fmt::format("{}: unknown key", core::printable(path));
  if (const auto key = meant(path)) return message + fmt::format("; did you mean {}?", *key);
  const std::string_view table = tableOf(path);
  return message + fmt::format("; {} has {}",
                               table.empty() ? "a scene" : fmt::format("[{}]", core::printable(table)),
                               joined(namesBelow(table)));
}

class Walk {
 public:
  Walk(Leaves& leaves, Problems& problems) : leaves_(leaves), problems_(problems) {}

  void table(std::string_view path, const Node::Table& entries) {
    for (const Entry& entry : entries) {
      const bool noName = entry.key.empty() || entry.key.find_first_of(".[]") != std::string::npos;
      if (noName)  // "a.b" in quotes is no path
        problems_.add(entry.keyPlace, fmt::format("\"{}\": unknown key", core::printable(entry.key)));
      else
        value(below(path, entry.key), entry.keyPlace, entry.value);
    }
  }

  void value(const std::string& path, const Place& keyPlace, const Node& node) {
    if (path.find('[') != std::string::npos && !exists(path))
      problems_.addLater(keyPlace,
                         [path, count = leaves_.count(arrayOf(path))] { return noElement(path, count); });
    else if (findKey(path))
      leaves_.values[path] = node;
    else if (isTableArray(path))
      array(path, node);
    else if (!isTable(path))
      problems_.addLater(keyPlace, [path] { return unknownKey(path); });
    else if (const auto* entries = node.as<Node::Table>())
      opened(path, keyPlace, *entries);
    else if (node.as<bool>() && hasVisible(path))
      leaves_.values[path + ".visible"] = node;
    else
      problems_.add(node.place, fmt::format("{}: expected a table [{}]{}, got {}", path, path,
                                            hasVisible(path) ? ", true or false" : "", describe(node)));
  }

 private:
  void opened(const std::string& path, const Place& place, const Node::Table& entries) {
    leaves_.tables[path] = place;
    table(path, entries);
  }

  /// Of a path with an index: whether that element was opened.
  bool exists(std::string_view path) const {
    const std::size_t end = path.find(']');
    return end != std::string_view::npos && leaves_.tables.contains(path.substr(0, end + 1));
  }

  static std::string noElement(const std::string& path, std::size_t count) {
    const std::string array(arrayOf(path));
    if (!isTableArray(array)) return unknownKey(path);
    if (path.find("[]") != std::string::npos) return unindexed(path, array);
    return fmt::format("{}: there is no such element; the scene has {} of [[{}]], counted from 0",
                       core::printable(path), count, array);
  }

  void array(const std::string& path, const Node& node) {
    const auto* elements = node.as<Node::Array>();
    if (!elements || !areTables(*elements))
      return problems_.add(
          node.place, fmt::format("{}: expected an array of tables, each begun with [[{}]], got {}", path, path,
                                  describe(node)));
    if (const auto most = leaves_.limits[Limit::kElements]; elements->size() > static_cast<std::size_t>(most))
      return problems_.add(node.place, fmt::format("{}: may have at most {} elements, got {}; {}", path, most,
                                                   elements->size(), howToRaise(Limit::kElements)));
    forget(path);
    for (std::size_t i = 0; i < elements->size(); ++i)
      opened(fmt::format("{}[{}]", path, i), (*elements)[i].place, *(*elements)[i].as<Node::Table>());
  }

  static bool areTables(const Node::Array& elements) {
    return std::all_of(elements.begin(), elements.end(),
                       [](const Node& element) { return element.as<Node::Table>() != nullptr; });
  }

  /// What an earlier value of an array gave, which this one replaces.
  void forget(const std::string& array) {
    const auto isBelow = [prefix = array + "["](const auto& entry) { return entry.first.starts_with(prefix); };
    std::erase_if(leaves_.values, isBelow);
    std::erase_if(leaves_.tables, isBelow);
  }

  Leaves& leaves_;
  Problems& problems_;
};

}  // namespace

std::size_t Leaves::count(std::string_view array) const {
  std::size_t count = 0;
  while (tables.contains(fmt::format("{}[{}]", array, count))) ++count;
  return count;
}

void addLeaves(const Node& document, Leaves& leaves, Problems& problems) {
  if (const auto* entries = document.as<Node::Table>()) Walk(leaves, problems).table("", *entries);
}

void addLeaf(const std::string& path, const Place& keyPlace, const Node& value, Leaves& leaves,
             Problems& problems) {
  Walk(leaves, problems).value(path, keyPlace, value);
}

}  // namespace poinsot::scene
