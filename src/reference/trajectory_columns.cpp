// SPDX-License-Identifier: Apache-2.0
#include "reference/trajectory_columns.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/text.h"
#include "scene/motion/make_motion.h"
#include "scene/motion/quantity_basis.h"

namespace poinsot::reference {
namespace {

using scene::StateQuantity;

/// Returns the unit in the form of kTrajectoryColumns, such as "kg m^2/s".
std::string_view unitOf(const StateQuantity& quantity) {
  const scene::Dimension dimension = scene::dimensionOf(quantity.unit);
  if (dimension == scene::Dimension::kNone) return "1";
  const std::string_view usual = scene::usualUnits(dimension);
  return usual.substr(0, usual.find(','));
}

std::vector<std::string> quantityNames() {
  std::vector<std::string> names;
  for (const StateQuantity& quantity : scene::stateQuantities()) names.emplace_back(quantity.name);
  return names;
}

std::vector<std::string> allNames() {
  std::vector<std::string> names = quantityNames();
  for (const TrajectoryColumn& column : kTrajectoryColumns)
    if (std::ranges::find(names, column.name) == names.end()) names.emplace_back(column.name);
  return names;
}

[[noreturn]] void refuseUnknown(const std::string& name, std::string_view option) {
  const std::vector<std::string> all = allNames();
  const auto closest = core::closest(name, all);
  const std::string list = closest ? fmt::format("did you mean {}? The names are", *closest) : "the names are";
  throw core::usageError(fmt::format("{}: no quantity has the name '{}'; {} {}", option, core::printable(name),
                                     list, core::joined(all, ", ")));
}

void checkExists(const StateQuantity& quantity, const scene::Scene& scene, std::string_view option) {
  if (const std::string lack = scene::lackFor(quantity, scene); !lack.empty())
    throw core::usageError(fmt::format("{}: {} {}", option, quantity.name, lack));
}

}  // namespace

TrajectoryRow trajectoryRow(const physics::Motion& motion, const physics::RigidBodyState& s) {
  const Eigen::Vector3d rate_B = physics::turningRate_B(motion, s);
  const Eigen::Vector3d rate_W = physics::turningRate_W(motion, s);
  return {s.t_s,           s.q_WB.w(),    s.q_WB.x(),    s.q_WB.y(),    s.q_WB.z(), s.omega_B.x(), s.omega_B.y(),
          s.omega_B.z(),   s.omega_W.x(), s.omega_W.y(), s.omega_W.z(), s.L_W.x(),  s.L_W.y(),     s.L_W.z(),
          s.kineticEnergy, rate_B.x(),    rate_B.y(),    rate_B.z(),    rate_W.x(), rate_W.y(),    rate_W.z()};
}

ChosenColumns::ChosenColumns(double alpha) {
  for (std::size_t place = 0; place < trajectoryColumns(alpha).size(); ++place) add({place, {}});
}

ChosenColumns::ChosenColumns(const scene::Scene& scene, const std::vector<std::string>& names,
                             std::string_view option) {
  add({kTimeAt, {}});
  for (const std::string& name : names) {
    const auto origin = originOf(name);
    if (!origin) refuseUnknown(name, option);
    if (std::ranges::count(names, name) > 1)
      throw core::usageError(fmt::format("{}: {} is given twice", option, name));
    if (origin->quantity) checkExists(scene::stateQuantity(*origin->quantity), scene, option);
    if (name != kTrajectoryColumns[kTimeAt].name) add(*origin);
  }
  const double start_s = scene.time.start_s;
  if (std::ranges::any_of(origins_, [](const Origin& origin) { return origin.quantity.has_value(); }))
    basis_ = scene::quantityBasis(scene, *scene::makeMotion(scene, start_s, start_s));
}

std::optional<ChosenColumns::Origin> ChosenColumns::originOf(const std::string& name) {
  const auto column = std::ranges::find(kTrajectoryColumns, name, &TrajectoryColumn::name);
  if (column != kTrajectoryColumns.end())
    return Origin{static_cast<std::size_t>(column - kTrajectoryColumns.begin()), {}};
  const auto all = scene::stateQuantities();
  const auto quantity = std::ranges::find(all, name, &StateQuantity::name);
  if (quantity == all.end()) return std::nullopt;
  return Origin{0, static_cast<int>(quantity - all.begin())};
}

void ChosenColumns::add(const Origin& origin) {
  origins_.push_back(origin);
  if (!origin.quantity) {
    columns_.push_back(kTrajectoryColumns[origin.place]);
    return;
  }
  const StateQuantity& quantity = scene::stateQuantity(*origin.quantity);
  columns_.push_back({quantity.name, unitOf(quantity)});
}

std::string ChosenColumns::header() const {
  std::vector<std::string_view> names;
  for (const TrajectoryColumn& column : columns_) names.push_back(column.name);
  return core::joined(names, ",");
}

void ChosenColumns::evaluate(const physics::Motion& motion, const physics::RigidBodyState& state,
                             std::vector<double>& values) const {
  const TrajectoryRow row = trajectoryRow(motion, state);
  values.clear();
  for (const Origin& origin : origins_)
    values.push_back(origin.quantity ? scene::stateQuantity(*origin.quantity).value(state, *basis_)
                                     : row[origin.place]);
}

std::vector<std::string> namesIn(std::string_view list) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    names.emplace_back(core::trimmed(list.substr(begin, end - begin)));
    begin = end + 1;
  }
  return names;
}

}  // namespace poinsot::reference
