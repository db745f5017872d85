// SPDX-License-Identifier: Apache-2.0
#include "scene/whole_angles.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "scene/units.h"

namespace poinsot::scene {
namespace {

std::optional<double> bareNumber(const Node& node) {
  if (const auto* integer = node.as<std::int64_t>()) return static_cast<double>(*integer);
  if (const auto* number = node.as<double>()) return *number;
  return std::nullopt;
}

}  // namespace

void doubtWholeAngles(const Leaves& leaves, Findings& findings) {
  const double degree = unitFactor("deg", Dimension::kAngle);
  for (const auto& [path, node] : leaves.values) {
    const auto number = bareNumber(node);
    if (findKey(path)->dimension != Dimension::kAngle || !number) continue;
    if (*number == 0 || *number != std::round(*number)) continue;
    findings.doubt(path, fmt::format("{} is in radians, {:.3g} deg; for degrees write \"{} deg\"", *number,
                                     *number / degree, *number));
  }
}

}  // namespace poinsot::scene
