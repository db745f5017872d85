// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <tuple>

#include "scene/keys/unknown_key.h"

namespace poinsot::scene {

bool Findings::hasBelow(std::string_view table) const {
  const std::string prefix = std::string(table) + ".";
  const auto next = given_.values.lower_bound(prefix);
  return next != given_.values.end() && next->first.starts_with(prefix);
}

bool Findings::hasTable(std::string_view table) const { return given_.tables.contains(table) || hasBelow(table); }

bool Findings::isMeantBelow(std::string_view table) const {
  const std::string prefix = std::string(table) + ".";
  const auto next = given_.meant.lower_bound(prefix);
  return next != given_.meant.end() && next->starts_with(prefix);
}

bool Findings::misspelt(std::string_view path) const {
  if (given_.meant.contains(path)) return true;
  const auto names = given_.unknown.find(tableOf(path));
  return names != given_.unknown.end() && std::ranges::any_of(names->second, [&](const std::string& name) {
           return scene::misspelt(tableOf(path), name) == path;
         });
}

bool Findings::isUnsure(std::string_view path) const {
  return failed(path) || misspelt(path) || misspelt(tableOf(path));
}

std::string Findings::textOf(std::string_view path) const {
  const auto found = given_.values.find(path);
  return found == given_.values.end() || found->second.as<DateOrTime>() ? "" : tomlText(found->second);
}

Place Findings::placeOf(std::string_view path) const {
  for (const std::string& given : {std::string(path), std::string(path) + ".visible"})
    if (const auto leaf = given_.values.find(given); leaf != given_.values.end()) return leaf->second.place;
  for (std::string_view table = path; !table.empty(); table = tableOf(table))
    if (const auto found = given_.tables.find(table); found != given_.tables.end()) return found->second;
  return file_;
}

bool Findings::isBroken(std::string_view path) const {
  const std::string_view top = path.substr(0, path.find_first_of(".["));
  const auto& broken = given_.broken;
  const auto any = [&](std::initializer_list<std::string_view> tables) {
    return std::ranges::any_of(tables, [&](std::string_view table) { return broken.contains(table); });
  };
  if (broken.empty() || broken.contains("")) return !broken.empty();
  if (top == "body") return any({"body"});
  if (top == "motion") return any({"body", "motion", "show", "view", "camera", "timeline"});
  return true;
}

void Findings::refuse(std::string_view path, std::string_view message) {
  if (isBroken(path)) return;
  if (!given_.broken.empty() && placeOf(path).line == 0) return;  // what is missing may be in the broken lines
  const Place place = placeOf(path);
  if (!place.source->hasLines()) message = message.substr(0, message.find(". For example"));  // no lines to paste
  problems_.add(place, fmt::format("{}: {}", path, message));
}

void Findings::refuseMissing(std::string_view missing, std::string_view path, std::string_view message) {
  if (!misspelt(missing)) refuse(path, message);
}

void Findings::refuseEmpty(std::string message) {
  if (given_.unknown.empty() && given_.broken.empty()) refuseFile(std::move(message));
}

void Findings::refuseFile(std::string message) { problems_.add(file_, std::move(message)); }

void Findings::doubt(std::string_view path, std::string_view message) {
  doubts_.push_back({locationOf(placeOf(path)), fmt::format("{}: {}", path, message)});
}

std::vector<Doubt> Findings::doubts() const {
  std::vector<Doubt> sorted = doubts_;
  std::ranges::stable_sort(sorted, {}, [](const Doubt& doubt) {
    return std::tie(doubt.where.file, doubt.where.line, doubt.where.column);
  });
  return sorted;
}

}  // namespace poinsot::scene
