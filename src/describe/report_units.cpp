// SPDX-License-Identifier: Apache-2.0
#include "describe/report_units.h"

#include <algorithm>
#include <type_traits>

namespace poinsot::describe {
namespace {

/// Returns the user's unit for a fact; null if the user chose none for the fact's dimension. The dimension is the
/// one whose first usual unit is the fact's own unit.
const request::UnitChoice::value_type* choiceFor(const Fact& fact, const request::UnitChoice& units) {
  const auto found = std::ranges::find_if(units, [&](const auto& choice) {
    const std::string_view usual = scene::usualUnits(choice.first);
    return usual.substr(0, usual.find(',')) == fact.unit;
  });
  return found == units.end() ? nullptr : &*found;
}

void divide(FactValue& value, double factor) {
  std::visit(
      [&](auto& v) {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, std::vector<double>>)
          for (double& one : v) one /= factor;
        else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Eigen::Vector3d> ||
                           std::is_same_v<T, Eigen::Matrix3d>)
          v /= factor;
      },
      value);
}

}  // namespace

Report inUnits(Report report, const request::UnitChoice& units) {
  for (Section& section : report.sections)
    for (Fact& fact : section.facts)
      if (const auto* choice = choiceFor(fact, units)) {
        divide(fact.value, scene::unitFactor(choice->second, choice->first));
        fact.unit = choice->second;
      }
  return report;
}

}  // namespace poinsot::describe
