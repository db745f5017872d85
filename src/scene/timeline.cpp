// SPDX-License-Identifier: Apache-2.0
#include "scene/timeline.h"

#include "scene/keys/key_tables.h"

namespace poinsot::scene {
namespace {

/// Returns the thing that a key shows: "ellipsoid" for "show.ellipsoid.visible". Empty for other keys.
std::string_view shownThing(std::string_view path) {
  constexpr std::string_view kBefore = "show.", kAfter = ".visible";
  if (!path.starts_with(kBefore) || !path.ends_with(kAfter)) return {};
  path.remove_prefix(kBefore.size());
  path.remove_suffix(kAfter.size());
  return path;
}

std::vector<std::string> namesOfThings() {
  std::vector<std::string> names;
  for (const Key& key : shownKeys())
    if (const std::string_view name = shownThing(key.path); !name.empty()) names.emplace_back(name);
  names.insert(names.end(), {"vectors", "angles", "labels", "title", "notes", "readouts"});
  return names;
}

}  // namespace

const std::vector<std::string>& timelineThings() {
  static const std::vector<std::string> names = namesOfThings();
  return names;
}

}  // namespace poinsot::scene
