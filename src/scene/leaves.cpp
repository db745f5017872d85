// SPDX-License-Identifier: Apache-2.0
#include "scene/leaves.h"

#include <fmt/format.h>

#include <optional>

#include "core/text.h"
#include "scene/check.h"

namespace poinsot::scene {
namespace {

// Longer than any name by far; the edit distance of untrusted kilobytes is not worth its time.
constexpr std::size_t kLongestName = 64;

std::optional<std::string> nameElsewhere(std::string_view name) {
  for (const Key& key : keys())
    if (nameOf(key.path) == name) return std::string(key.path);
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

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// The first part of a path that stands as a table and is none: "tim" of "tim.x".
std::optional<std::string_view> firstNoTable(std::string_view path) {
  for (std::size_t dot = path.find('.'); dot != std::string_view::npos; dot = path.find('.', dot + 1))
    if (!isTable(path.substr(0, dot))) return path.substr(0, dot);
  return std::nullopt;
}

std::string below(std::string_view table, std::string_view name) {
  return table.empty() ? std::string(name) : fmt::format("{}.{}", table, name);
}

std::vector<std::string> tablesBelow(std::string_view table) {
  std::vector<std::string> tables = namesBelow(table);
  std::erase_if(tables, [&](const std::string& name) { return !isTable(below(table, name)); });
  return tables;
}

/// What to write in place of a table that is none: the nearest one beside it, else a key of that name elsewhere.
std::string insteadOf(std::string_view table, std::string_view path) {
  const std::string_view parent = tableOf(table);
  const std::vector<std::string> tables = tablesBelow(parent);
  if (table.size() <= kLongestName)
    if (const auto near = core::closest(nameOf(table), tables))
      return fmt::format("did you mean [{}]?", below(parent, *near));
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

std::string unknownKey(std::string_view path) {
  if (const auto noTable = firstNoTable(path)) return unknownTable(path, *noTable);
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
      const bool dotted =
          entry.key.empty() || entry.key.find('.') != std::string::npos;  // "a.b" in quotes is no path
      if (dotted)
        problems_.add(entry.keyPlace, fmt::format("\"{}\": unknown key", core::printable(entry.key)));
      else
        value(path.empty() ? entry.key : fmt::format("{}.{}", path, entry.key), entry.keyPlace, entry.value);
    }
  }

  void value(const std::string& path, const Place& keyPlace, const Node& node) {
    if (findKey(path))
      leaves_[path] = node;
    else if (!isTable(path))
      problems_.addLater(keyPlace, [path] { return unknownKey(path); });
    else if (const auto* entries = node.as<Node::Table>())
      table(path, *entries);
    else if (node.as<bool>() && hasVisible(path))
      leaves_[path + ".visible"] = node;
    else
      problems_.add(node.place, fmt::format("{}: expected a table [{}]{}, got {}", path, path,
                                            hasVisible(path) ? ", true or false" : "", describe(node)));
  }

 private:
  Leaves& leaves_;
  Problems& problems_;
};

}  // namespace

void addLeaves(const Node& document, Leaves& leaves, Problems& problems) {
  if (const auto* entries = document.as<Node::Table>()) Walk(leaves, problems).table("", *entries);
}

void addLeaf(const std::string& path, const Place& keyPlace, const Node& value, Leaves& leaves,
             Problems& problems) {
  Walk(leaves, problems).value(path, keyPlace, value);
}

}  // namespace poinsot::scene
