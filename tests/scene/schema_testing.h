// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace poinsot::scene {

/// Returns the schema at a path, through properties, the object form of a table that may be a flag, and array
/// items.
inline const nlohmann::json& schemaAt(const nlohmann::json& schema, std::string_view path) {
  const nlohmann::json& object = schema.contains("properties") ? schema : schema["anyOf"][0];
  const std::size_t dot = path.find('.');
  const std::string_view name = path.substr(0, dot);
  const bool element = name.ends_with("[]");
  const nlohmann::json& named = object.at("properties").at(std::string(name.substr(0, name.find('['))));
  const nlohmann::json& next = element ? named.at("items") : named;
  return dot == std::string_view::npos ? next : schemaAt(next, path.substr(dot + 1));
}

}  // namespace poinsot::scene
