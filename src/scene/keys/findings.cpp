// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "scene/keys/unknown_key.h"

namespace poinsot::scene {

bool Findings::hasBelow(std::string_view table) const {
  const std::string prefix = std::string(table) + ".";
  const auto next = given_.values.lower_bound(prefix);
  return next != given_.values.end() && next->first.starts_with(prefix);
}

bool Findings::hasTable(std::string_view table) const { return given_.tables.contains(table) || hasBelow(table); }

bool Findings::misspelt(std::string_view path) const {
  const auto names = given_.unknown.find(tableOf(path));
  return names != given_.unknown.end() && std::ranges::any_of(names->second, [&](const std::string& name) {
           return scene::misspelt(tableOf(path), name) == path;
         });
}

bool Findings::isUnsure(std::string_view path) const {
  return failed(path) || misspelt(path) || misspelt(tableOf(path));
}

Place Findings::placeOf(std::string_view path) const {
  for (const std::string& given : {std::string(path), std::string(path) + ".visible"})
    if (const auto leaf = given_.values.find(given); leaf != given_.values.end()) return leaf->second.place;
  for (std::string_view table = path; !table.empty(); table = tableOf(table))
    if (const auto found = given_.tables.find(table); found != given_.tables.end()) return found->second;
  return file_;
}

void Findings::refuse(std::string_view path, std::string_view message) {
  problems_.add(placeOf(path), fmt::format("{}: {}", path, message));
}

void Findings::refuseMissing(std::string_view missing, std::string_view path, std::string_view message) {
  if (!misspelt(missing)) refuse(path, message);
}

void Findings::refuseEmpty(std::string message) {
  if (given_.unknown.empty()) refuseFile(std::move(message));
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
