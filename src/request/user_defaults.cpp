// SPDX-License-Identifier: Apache-2.0
#include "request/user_defaults.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.h"
#include "core/text.h"
#include "request/scene_request.h"
#include "request/user_file.h"
#include "scene/document/document.h"

namespace poinsot::request {
namespace {

namespace fs = std::filesystem;
using scene::Entry;
using scene::Node;
using scene::Problems;

std::optional<scene::Dimension> dimensionNamed(std::string_view word) {
  const auto all = scene::dimensions();
  const auto found = std::ranges::find(all, word, dimensionWord);
  return found == all.end() ? std::nullopt : std::optional(*found);
}

void takeUnit(const Entry& entry, UnitChoice& units, Problems& problems) {
  const auto dimension = dimensionNamed(entry.key);
  const auto* unit = entry.value.as<std::string>();
  if (!dimension) {
    std::vector<std::string> words;
    for (const scene::Dimension one : scene::dimensions()) words.push_back(dimensionWord(one));
    const auto near = core::closest(entry.key.substr(0, 64), words);
    return problems.add(entry.keyPlace, fmt::format("units.{}: {}", core::printable(entry.key),
                                                    near ? fmt::format("did you mean {}?", *near)
                                                         : fmt::format("there is {}", fmt::join(words, ", "))));
  }
  if (!unit || !scene::parseQuantity("1 " + *unit, *dimension).ok())
    return problems.add(entry.value.place, fmt::format("units.{}: expected a unit such as {}, got {}", entry.key,
                                                       scene::someUnits(*dimension), describe(entry.value)));
  units[*dimension] = *unit;
}

/// What is wrong with it in a scene that says nothing else; empty: nothing.
std::string problemOf(const DefaultKey& key) {
  if (key.path.starts_with("body.") || key.path.starts_with("motion."))
    return key.path + ": of what a scene is about there is no default";
  constexpr const char* kScene = "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0, 0.1, 1]\n";
  try {
    loadRequested({"defaults.toml", kScene, {key.path + "=" + key.value}, std::nullopt, {}});
  } catch (const scene::SceneErrors& errors) {
    return errors.problems().front().message;
  }
  return {};
}

void takeKeys(const Node::Table& table, const std::string& above, UserDefaults& defaults, Problems& problems) {
  for (const Entry& entry : table) {
    const std::string path = above + entry.key;
    if (const auto* below = entry.value.as<Node::Table>()) {
      takeKeys(*below, path + ".", defaults, problems);
      continue;
    }
    DefaultKey key{path, tomlText(entry.value)};
    if (const std::string problem = problemOf(key); problem.empty())
      defaults.keys.push_back(std::move(key));
    else
      problems.add(entry.keyPlace, problem);
  }
}

void take(const Entry& entry, UserDefaults& defaults, Problems& problems) {
  const auto* table = entry.value.as<Node::Table>();
  if (table && entry.key == "units")
    for (const Entry& unit : *table) takeUnit(unit, defaults.units, problems);
  else if (table && entry.key == "scene")
    takeKeys(*table, "", defaults, problems);
  else
    problems.add(entry.keyPlace,
                 fmt::format("{}: there are the tables [units] and [scene]", core::printable(entry.key)));
}

}  // namespace

fs::path userDefaultsFile() { return userFile("defaults.toml"); }

UserDefaults defaultsOf(const fs::path& file) {
  UserDefaults defaults;
  readUserFile(file, [&](const Entry& entry, Problems& problems) { take(entry, defaults, problems); });
  return defaults;
}

std::string dimensionWord(scene::Dimension dimension) {
  const std::string_view name = scene::quantityName(dimension);  // "an angular velocity"
  std::string word(name.substr(name.find(' ') + 1));
  std::ranges::replace(word, ' ', '_');
  return word;
}

}  // namespace poinsot::request
