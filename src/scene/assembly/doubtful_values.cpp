// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/assemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "scene/units.h"

namespace poinsot::scene {
namespace {

constexpr double kDensest_kg_m3 = 23000;  // osmium, the densest metal, has 22 590 kg/m³
constexpr double kLong_m = 2;             // large for a body whose other lengths have a unit, such as cm

std::optional<double> bareNumber(const Node& node) {
  if (const auto* integer = node.as<std::int64_t>()) return static_cast<double>(*integer);
  if (const auto* number = node.as<double>()) return *number;
  return std::nullopt;
}

/// Returns the SI value of a node, which is a bare number or text with a unit. Returns nullopt for invalid text.
std::optional<double> valueOf(const Node& node, Dimension dimension) {
  const auto* text = node.as<std::string>();
  if (!text) return bareNumber(node);
  const Quantity read = parseQuantity(*text, dimension);
  return read.ok() ? std::optional(read.value) : std::nullopt;
}

std::vector<Node> elementsOf(const Node& node) {
  const auto* array = node.as<Node::Array>();
  return array ? std::vector<Node>(array->begin(), array->end()) : std::vector<Node>{node};
}

void doubtAngle(const std::string& path, const Node& node, Findings& findings) {
  const auto number = bareNumber(node);
  if (!number || *number == 0 || *number != std::round(*number)) return;
  findings.doubt(path, fmt::format("{} is in radians ({:.3g} deg); for degrees write \"{} deg\"", *number,
                                   *number / unitFactor("deg", Dimension::kAngle), *number));
}

void doubtDensity(const std::string& path, const Node& node, Findings& findings) {
  const auto density = valueOf(node, Dimension::kDensity);
  if (density && *density > kDensest_kg_m3)
    findings.doubt(path, fmt::format("a density of {:.4g} kg/m^3 is higher than that of any metal", *density));
}

bool isBodyLength(const std::string& path) {
  return path.starts_with("body") && findKey(path)->dimension == Dimension::kLength;
}

void doubtBareLengths(const Leaves& leaves, Findings& findings) {
  const auto hasUnit = [](const auto& leaf) {
    return isBodyLength(leaf.first) && std::ranges::any_of(elementsOf(leaf.second), [](const Node& element) {
             return element.template as<std::string>() != nullptr;
           });
  };
  if (std::ranges::none_of(leaves.values, hasUnit)) return;
  for (const auto& [path, node] : leaves.values)
    for (const Node& element : isBodyLength(path) ? elementsOf(node) : std::vector<Node>())
      if (const auto metres = bareNumber(element); metres && std::abs(*metres) >= kLong_m)
        findings.doubt(path, fmt::format("{} is in metres; other lengths of this body have a unit", *metres));
}

}  // namespace

void doubtValues(const Leaves& leaves, Findings& findings) {
  for (const auto& [path, node] : leaves.values) {
    const Dimension dimension = findKey(path)->dimension;
    if (dimension == Dimension::kAngle) doubtAngle(path, node, findings);
    if (dimension == Dimension::kDensity) doubtDensity(path, node, findings);
  }
  doubtBareLengths(leaves, findings);
}

}  // namespace poinsot::scene
