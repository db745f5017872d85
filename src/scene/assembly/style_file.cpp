// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/style_file.h"

#include <fmt/format.h>

#include "core/error.h"
#include "scene/keys/check.h"
#include "scene/keys/key_tables.h"

namespace poinsot::scene {
namespace {

constexpr std::string_view kKey = "style.file";

/// Returns why a key is not allowed in a style file; empty if the key is allowed.
std::string_view misplaced(std::string_view path) {
  if (path == kKey) return "a style file must not name another style file";
  if (path == "schema" || path.starts_with("style.")) return "";
  return "a style file may contain only [style] and [style.colors]; other keys belong in the scene";
}

const Source* openFile(const Node& name, const SceneFolder& folder, std::deque<Source>& sources,
                       Problems& problems) {
  const auto* path = name.as<std::string>();
  if (!path || static_cast<double>(characterCount(*path)) > kPathLength.most)
    return nullptr;  // the check of the key style.file reports this
  try {
    std::string text = folder.read(*path);
    return &sources.emplace_back(folder.filesRead().back().place.string(), std::move(text));
  } catch (const core::Error& error) {
    problems.add(name.place, fmt::format("{}: {}", kKey, error.message()));
    return nullptr;
  }
}

/// Adds the values of the style file to those of the scene. If the scene gives a value too, the scene's value is
/// kept and the file's is only checked.
void take(const Leaves& file, Leaves& leaves, Problems& problems) {
  for (const auto& [path, node] : file.values)
    if (const std::string_view why = misplaced(path); !why.empty())
      problems.add(node.place, fmt::format("{}: {}", path, why));
    else if (leaves.values.contains(path))
      check(*findKey(path), path, node, problems, leaves.limits);
    else
      leaves.values.emplace(path, node);
}

}  // namespace

void addStyleFile(const SceneFolder& folder, std::deque<Source>& sources, Leaves& leaves, Problems& problems) {
  const auto named = leaves.values.find(kKey);
  if (named == leaves.values.end()) return;
  const Source* source = openFile(named->second, folder, sources, problems);
  if (!source) return;
  Leaves file{.limits = leaves.limits};
  addLeaves(parseValidParts(*source, leaves.limits, problems).root, file, problems);
  take(file, leaves, problems);
}

}  // namespace poinsot::scene
