// SPDX-License-Identifier: Apache-2.0
#include "physics/forcing.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "physics/require_finite.h"
#include "physics/rotor.h"

namespace poinsot::physics {
namespace {

std::string triple(const Eigen::Vector3d& v) { return fmt::format("({}, {}, {})", v[0], v[1], v[2]); }

void requireAscending(const char* what, const TorqueHistory& history, std::size_t i) {
  const double t = history.t_s[i];
  if (!std::isfinite(t))
    throw core::physicsError(fmt::format("times of {} must be finite, time {} is {} s", what, i + 1, t));
  if (i > 0 && t <= history.t_s[i - 1])
    throw core::physicsError(
        fmt::format("times of {} must ascend, time {} is {} s after {} s", what, i + 1, t, history.t_s[i - 1]));
}

void validateHistory(const char* what, const TorqueHistory& history) {
  if (history.t_s.size() != history.torque.size())
    throw core::physicsError(fmt::format("{} needs one torque for each time, got {} times and {} torques", what,
                                         history.t_s.size(), history.torque.size()));
  for (std::size_t i = 0; i < history.t_s.size(); ++i) {
    requireAscending(what, history, i);
    requireFinite(history.torque[i], what);
  }
}

void validateForce(const PointForce& force, std::size_t i) {
  const std::string name = fmt::format("force {}", i + 1);
  requireFinite(force.lever_B, "the point of " + name + " (m)");
  requireFinite(force.force_B, name + " in body axes (N)");
  requireFinite(force.force_W, name + " in space axes (N)");
  if (!(force.from_s < force.to_s))
    throw core::physicsError(
        fmt::format("{} must end after it begins, got {} s to {} s", name, force.from_s, force.to_s));
}

}  // namespace

void validate(const Forcing& forcing) {
  requireFinite(forcing.gravity_B, "gravity (M g r in body axes, N·m)");
  requireFinite(forcing.torque_B, "the torque in body axes (N·m)");
  requireFinite(forcing.torque_W, "the torque in space axes (N·m)");
  requireFinite(forcing.dragRate_P, "the drag rates (1/s)");
  if (forcing.dragRate_P.minCoeff() < 0)
    throw core::physicsError(
        fmt::format("drag rates must not be negative, got {} 1/s", triple(forcing.dragRate_P)));
  if (!(forcing.dissipation >= 0 && std::isfinite(forcing.dissipation)))
    throw core::physicsError(fmt::format("the dissipation alpha must be finite and not negative, got {} s/(kg·m²)",
                                         forcing.dissipation));
  validateHistory("the torque table in body axes", forcing.torqueHistory_B);
  validateHistory("the torque table in space axes", forcing.torqueHistory_W);
  for (std::size_t i = 0; i < forcing.forces.size(); ++i) validateForce(forcing.forces[i], i);
}

double potentialEnergy(const Forcing& forcing, const Quaternion& q) {
  const Eigen::Vector3d& r = forcing.gravity_B;
  return rotated(Rotor<double>{q.w(), q.x(), q.y(), q.z()}, std::array{r[0], r[1], r[2]})[2];
}

}  // namespace poinsot::physics
