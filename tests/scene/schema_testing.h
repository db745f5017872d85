// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace poinsot::scene {

/// The schema of a path: through properties, and through the object of a table that may be a flag.
inline const nlohmann::json& schemaAt(const nlohmann::json& schema, std::string_view path) {
  const nlohmann::json& object = schema.contains("anyOf") ? schema["anyOf"][0] : schema;
  const std::size_t dot = path.find('.');
  const nlohmann::json& next = object.at("properties").at(std::string(path.substr(0, dot)));
  return dot == std::string_view::npos ? next : schemaAt(next, path.substr(dot + 1));
}

}  // namespace poinsot::scene
