// SPDX-License-Identifier: Apache-2.0
#include "request/user_files.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "core/error.h"
#include "core/regular_file.h"
#include "core/text.h"
#include "request/scene_request.h"
#include "scene/document/document.h"
#include "scene/limits.h"

namespace poinsot::request {

namespace {

namespace fs = std::filesystem;
using scene::Entry;
using scene::Node;
using scene::Problems;

/// Returns the folder that an environment variable names. Empty if the path is relative, as XDG requires.
fs::path folderNamed(const char* variable) {
  const char* value = std::getenv(variable);
  const fs::path folder = value ? value : "";
  return folder.is_absolute() ? folder : fs::path();
}

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
                                                    near ? fmt::format("unknown quantity; did you mean {}?", *near)
                                                         : fmt::format("unknown quantity; expected one of {}",
                                                                       core::joined(words, ", "))));
  }
  if (!unit || !scene::parseQuantity("1 " + *unit, *dimension).ok())
    return problems.add(entry.value.place, fmt::format("units.{}: expected a unit such as {}, got {}", entry.key,
                                                       scene::someUnits(*dimension), describe(entry.value)));
  units[*dimension] = *unit;
}

/// Returns what is wrong with a default, by loading a minimal scene with it. Empty if nothing is wrong.
std::string problemOf(const DefaultKey& key) {
  if (key.path.starts_with("body.") || key.path.starts_with("motion."))
    return key.path + ": keys of [body] and [motion] cannot have a default";
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
                 fmt::format("{}: unknown key; this file may contain only the tables [units] and [scene]",
                             core::printable(entry.key)));
}

}  // namespace

fs::path userDefaultsFile() {
  fs::path folder = folderNamed("XDG_CONFIG_HOME");
  if (const fs::path home = folderNamed("HOME"); folder.empty() && !home.empty()) folder = home / ".config";
  return folder.empty() ? folder : folder / "poinsot" / "defaults.toml";
}

UserDefaults defaultsOf(const fs::path& file) {
  UserDefaults defaults;
  std::error_code ignored;  // a file that cannot be found counts as empty
  if (file.empty() || !fs::exists(file, ignored)) return defaults;
  const std::size_t most = scene::Limits().bytes(scene::Limit::kSceneBytes);
  const scene::Source source(file.string(), core::readRegularFile(file, most, core::ErrorKind::kIo));
  const Node document = parseDocument(source);
  Problems problems;
  for (const Entry& entry : *document.as<Node::Table>()) take(entry, defaults, problems);
  problems.throwIfAny();
  return defaults;
}

std::string dimensionWord(scene::Dimension dimension) {
  const std::string_view name = scene::quantityName(dimension);  // such as "an angular velocity"
  std::string word(name.substr(name.find(' ') + 1));
  std::ranges::replace(word, ' ', '_');
  return word;
}

}  // namespace poinsot::request
