// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/unknown_key.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/text.h"
#include "scene/keys/foreign_names.h"
#include "scene/keys/key_text.h"
#include "scene/keys/keys.h"

namespace poinsot::scene {
namespace {

/// Returns the singular of a name: "quantity" for "quantities", "label" for "labels".
std::string singular(std::string_view name) {
  if (name.ends_with("ies")) return fmt::format("{}y", name.substr(0, name.size() - 3));
  return std::string(name.ends_with('s') ? name.substr(0, name.size() - 1) : name);
}

bool isColor(std::string_view name) {
  return name == "color" || name == "colour" || name == "colors" || name == "colours";
}

/// Returns the key that sets the colour of a thing, such as style.colors.body for show.body.
std::string colorOf(std::string_view table) {
  const std::string key = fmt::format("style.colors.{}", table.empty() ? "body" : nameOf(table));
  return findKey(key) ? key : tableText("style.colors");
}

/// Returns the path of a key with the same name in a table one level below: view[1].show.plane for view[1].plane.
std::optional<std::string> deeper(std::string_view table, std::string_view name) {
  for (const std::string& inner : namesBelow(table)) {
    const std::string path = pathBelow(pathBelow(table, inner), name);
    if (findKey(path) || isTable(path)) return path;
  }
  return std::nullopt;
}

bool holdsKeys(std::string_view path) { return isTable(path) || isTableArray(path); }

/// Returns the first part of a path that is not a table, although names follow it: "tim" for "tim.x".
std::optional<std::string_view> firstNoTable(std::string_view path) {
  for (std::size_t dot = path.find('.'); dot != std::string_view::npos; dot = path.find('.', dot + 1))
    if (!holdsKeys(path.substr(0, dot))) return path.substr(0, dot);
  return std::nullopt;
}

std::vector<std::string> tablesBelow(std::string_view table) {
  std::vector<std::string> tables = namesBelow(table);
  std::erase_if(tables, [&](const std::string& name) { return !holdsKeys(pathBelow(table, name)); });
  return tables;
}

std::string whole(std::string_view table) {
  return table.empty() ? "a scene" : fmt::format("[{}]", core::printable(table));
}

std::string insteadOf(std::string_view table, std::string_view path) {
  const std::string_view parent = tableOf(table);
  const std::vector<std::string> tables = tablesBelow(parent);
  if (table.size() <= kLongestName)
    if (const auto near = core::closest(nameOf(table), tables))
      return fmt::format("did you mean {}?", tableText(pathBelow(parent, *near)));
  if (const auto key = otherKey(path)) return fmt::format("did you mean {}?", *key);
  return fmt::format("{} has the tables {}", whole(parent), core::joined(tables, ", "));
}

std::string unknownTable(std::string_view path, std::string_view table) {
  const std::string shown = core::printable(path);
  if (const Key* key = findKey(table))
    return fmt::format("{}: unknown key; {} is {}, and has no keys below it", shown, table, typeText(*key));
  return fmt::format("{}: unknown table [{}]; {}", shown, core::printable(table), insteadOf(table, path));
}

std::optional<std::string> meant(std::string_view path, bool elsewhere) {
  if (nameOf(path).size() > kLongestName) return std::nullopt;
  for (const ForeignNames* row : plausibleRows(path))
    if (row->carry != Carry::kLaunch) return keyFor(*row, path);  // a launch needs a second name
  if (auto near = misspelt(tableOf(path), nameOf(path))) return near;
  return elsewhere ? otherKey(path) : std::nullopt;
}

/// Returns the key to which a path to a single element belongs, such as "motion.omega_body[1]"; otherwise null.
const Key* keyOfElement(std::string_view path) {
  const auto bracket = path.rfind('[');
  return path.ends_with(']') && bracket != std::string_view::npos ? findKey(path.substr(0, bracket)) : nullptr;
}

}  // namespace

std::string unknownKey(std::string_view path, bool elsewhere) {
  if (const Key* key = keyOfElement(path))
    return fmt::format("{}: a single element cannot be set; give the whole array, such as {}={}",
                       core::printable(path), path.substr(0, path.rfind('[')),
                       key->example.empty() ? key->fallback : key->example);
  if (const auto noTable = firstNoTable(path)) return unknownTable(path, *noTable);
  const std::string_view table = tableOf(path);
  if (isTableArray(table)) return withoutIndex(path, table);
  const std::string message = fmt::format("{}: unknown key", core::printable(path));
  if (const auto key = meant(path, elsewhere)) return message + fmt::format("; did you mean {}?", *key);
  return message + fmt::format("; {} has {}", whole(table), core::joined(namesBelow(table), ", "));
}

std::optional<std::string> sameName(std::string_view name) {
  std::optional<std::string> found;
  for (const Key& key : keys())
    if (nameOf(key.path) == name && !repeatsInView(key)) {
      if (key.path.find('[') == std::string::npos) return key.path;
      if (!found) found = key.path;
    }
  return found;
}

std::optional<std::string> otherKey(std::string_view path) {
  const std::string_view name = nameOf(path);
  if (isColor(name)) return colorOf(tableOf(path));
  if (auto found = deeper(tableOf(path), name)) return found;
  if (const std::string thing = pathBelow("show", name); isTable(thing)) return thing;
  return sameName(name);
}

std::string withoutIndex(std::string_view path, std::string_view array) {
  return fmt::format("{}: [[{}]] is an array of tables; name one by its number from 0, such as {}[0]",
                     core::printable(path), array, array);
}

std::string tableElsewhere(std::string_view name) {
  constexpr auto kTables = std::to_array<std::pair<std::string_view, std::string_view>>({
      {"rigid_body", "body"},
      {"object", "body"},
      {"geometry", "body"},
      {"inertia", "body"},
      {"initial", "motion"},
      {"initial_conditions", "motion"},
      {"initial_state", "motion"},
      {"ic", "motion"},
      {"state", "motion"},
      {"dynamics", "motion"},
      {"kinematics", "motion"},
      {"forces", "motion"},
      {"force", "motion"},
      {"physics", "motion"},
      {"environment", "motion"},
      {"start", "motion"},
      {"euler_angles", "motion.euler"},
      {"damping", "motion.drag"},
      {"friction", "motion.drag"},
      {"energy_dissipation", "motion.dissipation"},
      {"energy_loss", "motion.dissipation"},
      {"internal_damping", "motion.dissipation"},
      {"internal_friction", "motion.dissipation"},
      {"internal_dissipation", "motion.dissipation"},
      {"torques", "motion.torque"},
      {"throw", "motion.flight"},
      {"film", "time"},
      {"movie", "time"},
      {"animation", "time"},
      {"simulation", "time"},
      {"sim", "time"},
      {"timing", "time"},
      {"video", "output"},
      {"render", "output"},
      {"rendering", "output"},
      {"export", "output"},
      {"figure", "output"},
      {"display", "show"},
      {"draw", "show"},
      {"visuals", "show"},
      {"visualization", "show"},
      {"colours", "style.colors"},
      {"appearance", "style"},
  });
  if (name.size() > kLongestName || name.find('.') != std::string_view::npos) return "";
  const auto found = std::ranges::find(kTables, name, &std::pair<std::string_view, std::string_view>::first);
  if (found != kTables.end()) return std::string(found->second);
  for (const std::string_view parent : {"motion", "style", "show"})
    if (std::string path = pathBelow(parent, name); isTable(path)) return path;
  return "";
}

std::optional<std::string> misspelt(std::string_view table, std::string_view name) {
  if (name.size() > kLongestName) return std::nullopt;
  for (const std::string& known : namesBelow(table))
    if (singular(known) == singular(name)) return pathBelow(table, known);
  if (sameName(name)) return std::nullopt;  // the right name in a wrong table, not a misspelling
  const auto near = core::closest(name, namesBelow(table));
  return near ? std::optional(pathBelow(table, *near)) : std::nullopt;
}

}  // namespace poinsot::scene
