// SPDX-License-Identifier: Apache-2.0
#include "scene/leaves.h"

#include <fmt/format.h>

#include <optional>

#include "core/text.h"

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

std::string unknownKey(std::string_view path) {
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
