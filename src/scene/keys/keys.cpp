// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

namespace poinsot::scene {
namespace {

// Largest number of digits that count as an index. All valid indices have fewer digits.
constexpr std::size_t kMostDigits = 9;

bool isIndexDigit(char c) { return c >= '0' && c <= '9'; }

/// Returns the digits of the first index in a path, such as "3" for "body.part[3].mass"; empty if there is none.
std::string_view indexIn(std::string_view path) {
  const std::size_t open = path.find('[');
  if (open == std::string_view::npos) return {};
  const std::string_view rest = path.substr(open + 1);
  const std::string_view digits = rest.substr(0, rest.find(']'));
  const bool number = digits.size() < rest.size() && digits.size() <= kMostDigits &&
                      std::all_of(digits.begin(), digits.end(), isIndexDigit);
  return number ? digits : std::string_view();
}

using KeysByPath = std::map<std::string_view, const Key*>;

const KeysByPath& keysByPath() {
  static const auto byPath = [] {
    KeysByPath map;
    for (const Key& key : keys()) map.emplace(key.path, &key);
    return map;
  }();
  return byPath;
}

bool someKeyStarts(std::string_view prefix) {
  const auto first = keysByPath().lower_bound(prefix);
  return first != keysByPath().end() && first->first.starts_with(prefix);
}

}  // namespace

std::string patternOf(std::string_view path) {
  const std::string_view digits = indexIn(path);
  if (digits.empty()) return std::string(path);
  const auto begin = static_cast<std::size_t>(digits.data() - path.data());
  return std::string(path.substr(0, begin)).append(path.substr(begin + digits.size()));
}

std::size_t elementOf(std::string_view path) {
  const std::string_view digits = indexIn(path);
  std::size_t element = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), element);
  return element;
}

const Key* findKey(std::string_view path) {
  const auto found = keysByPath().find(patternOf(path));
  return found == keysByPath().end() ? nullptr : found->second;
}

bool isTable(std::string_view path) { return someKeyStarts(patternOf(path) + "."); }

bool isTableArray(std::string_view path) { return someKeyStarts(patternOf(path) + "[]."); }

std::vector<std::string> namesBelow(std::string_view table) {
  const std::string prefix = table.empty() ? "" : patternOf(table) + ".";
  std::vector<std::string> names;
  for (const Key& key : keys()) {
    if (!key.path.starts_with(prefix)) continue;
    const std::string_view rest = std::string_view(key.path).substr(prefix.size());
    std::string name(rest.substr(0, rest.find_first_of(".[")));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  return names;
}

std::string_view tableOf(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : path.substr(0, dot);
}

std::string pathBelow(std::string_view table, std::string_view name) {
  return table.empty() ? std::string(name) : fmt::format("{}.{}", table, name);
}

std::string_view nameOf(std::string_view path) { return path.substr(path.rfind('.') + 1); }

bool repeatsInView(const Key& key) {
  return key.path.starts_with("view[].") && tableOf(key.path) != std::string_view("view[]");
}

bool hasVisible(std::string_view table) { return findKey(std::string(table) + ".visible") != nullptr; }

bool isExtra(std::string_view table) {
  if (!hasVisible(table)) return false;
  return findKey(std::string(table.substr(table.find("show."))) + ".visible")->fallback == "false";
}

}  // namespace poinsot::scene
