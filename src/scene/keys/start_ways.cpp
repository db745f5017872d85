// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/start_ways.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "core/expect.h"

namespace poinsot::scene {
namespace {

using enum StartPart;

bool areParts(const StartWay& a, const StartWay& b, StartPart one, StartPart other) {
  return (a.part == one && b.part == other) || (a.part == other && b.part == one);
}

bool isOneOf(const StartWay& a, const StartWay& b, std::string_view name) {
  return a.name == name || b.name == name;
}

/// Returns whether the two are a rotation and a property of another rotation: only `spin` has these properties.
bool isOfOtherRotation(const StartWay& a, const StartWay& b) {
  const bool one = areParts(a, b, kRotation, kTilt) || areParts(a, b, kRotation, kTop);
  return one && !isOneOf(a, b, "spin and spin_axis");
}

}  // namespace

std::span<const StartWay> startWays() {
  static const std::vector<StartWay> ways = {
      {"omega_body", kRotation, {"omega_body"}},
      {"omega_space", kRotation, {"omega_space"}},
      {"L_body", kRotation, {"L_body"}},
      {"L_space", kRotation, {"L_space"}},
      {"spin and spin_axis", kRotation, {"spin", "spin_axis"}, 2},
      {"energy and L", kRotation, {"energy", "L", "phase", "branch"}, 2},
      {"P_phi and P_psi", kRotation, {"P_phi", "P_psi", "mode", "phase", "branch"}, 2},
      {"euler_rates", kRotation, {"euler_rates."}},
      {"a rate of precession", kRotation, {"precession"}},
      {"tilt", kTilt, {"tilt", "tilt_towards"}},
      {"precession slow or fast", kTop, {"precession"}},
      {"nutation", kTop, {"nutation"}},
      {"lean", kAttitude, {"lean", "spin_axis"}},
      {"euler", kAttitude, {"euler."}},
      {"roll_pitch_yaw", kAttitude, {"roll_pitch_yaw"}},
      {"orientation", kAttitude, {"orientation"}},
  };
  return ways;
}

const StartWay& startWay(std::string_view name) {
  const auto found = std::ranges::find(startWays(), name, &StartWay::name);
  POINSOT_EXPECT(found != startWays().end());
  return *found;
}

bool combine(const StartWay& a, const StartWay& b) {
  if (a.part == b.part || areParts(a, b, kTilt, kTop) || isOfOtherRotation(a, b)) return false;
  const bool ratesOfOtherAngles = areParts(a, b, kRotation, kAttitude) && isOneOf(a, b, "euler_rates");
  return !ratesOfOtherAngles || isOneOf(a, b, "euler");
}

std::string startWaysMarkdown() {
  std::vector<StartWay> rows, columns;
  std::ranges::partition_copy(startWays(), std::back_inserter(rows), std::back_inserter(columns),
                              [](const StartWay& way) { return way.part == kRotation; });

  std::string heading = "| |", line = "| --- |", body;
  for (const StartWay& column : columns) {
    heading += fmt::format(" {} |", column.name);
    line += " --- |";
  }
  for (const StartWay& row : rows) {
    body += fmt::format("| {} |", row.name);
    for (const StartWay& column : columns) body += combine(row, column) ? " yes |" : " no |";
    body += "\n";
  }
  return fmt::format("{}\n{}\n{}", heading, line, body);
}

}  // namespace poinsot::scene
