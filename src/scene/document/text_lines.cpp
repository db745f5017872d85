// SPDX-License-Identifier: Apache-2.0
#include "scene/document/text_lines.h"

#include <string>
#include <string_view>

namespace poinsot::scene {

std::vector<Node> linesOf(const Node& node) {
  if (const auto* array = node.as<Node::Array>()) return *array;
  const auto* text = node.as<std::string>();
  if (!text) return {node};
  std::vector<Node> lines;
  std::string_view rest = *text;
  while (!rest.empty() || lines.empty()) {
    const std::size_t end = rest.find('\n');
    lines.push_back({std::string(rest.substr(0, end)), node.place});
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  }
  return lines;
}

}  // namespace poinsot::scene
