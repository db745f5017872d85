// SPDX-License-Identifier: Apache-2.0
#include "physics/forcing_piece.h"

#include <algorithm>

#include "physics/fixed_order.h"

namespace poinsot::physics {
namespace {

std::array<double, 3> components(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

/// Linear part of a torque table: the value at a reference time, and the slope.
struct Line {
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
};

Line lineOf(const TorqueHistory& history, double inside, double reference) {
  const auto& t = history.t_s;
  const auto next = static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), inside) - t.begin());
  if (next == 0 || (history.linear && next == t.size())) return {};
  const Eigen::Vector3d& value = history.torque[next - 1];
  if (!history.linear) return {value, Eigen::Vector3d::Zero()};
  const Eigen::Vector3d slope = (history.torque[next] - value) / (t[next] - t[next - 1]);
  return {value + (reference - t[next - 1]) * slope, slope};
}

/// Force at a point, with its torque along P.
struct PushingForce {
  const PointForce* force;
  std::array<double, 3> torque_P;  // of the part that turns with the body
  LeverTorque lever;               // of the part that keeps its direction in space
};

std::vector<PushingForce> pushingForces(const Forcing& forcing, const PrincipalAxes& axes) {
  std::vector<PushingForce> all;
  for (const PointForce& force : forcing.forces) {
    PushingForce pushing{&force, components(axes.toP(crossProduct(force.lever_B, force.force_B))), {}};
    const Eigen::Vector3d lever_P = axes.toP(force.lever_B);
    for (std::size_t c = 0; c < 3; ++c)
      pushing.lever.columns_P[c] = components(lever_P * force.force_W[static_cast<Eigen::Index>(c)]);
    all.push_back(pushing);
  }
  return all;
}

/// Adds the torques of the forces that act at the time `inside` to a piece.
void addForces(const std::vector<PushingForce>& forces, double inside, ForcingPiece& piece) {
  for (const PushingForce& pushing : forces) {
    if (!pushing.force->actsAt(inside)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      piece.torque_P.start[i] += pushing.torque_P[i];
      for (std::size_t c = 0; c < 3; ++c) piece.lever.columns_P[c][i] += pushing.lever.columns_P[c][i];
    }
  }
}

ForcingPiece pieceBetween(const Forcing& forcing, const std::vector<PushingForce>& forces,
                          const PrincipalAxes& axes, double begin, double end) {
  const double inside = begin + 0.5 * (end - begin);
  const Line body = lineOf(forcing.torqueHistory_B, inside, begin);
  const Line space = lineOf(forcing.torqueHistory_W, inside, begin);
  ForcingPiece piece{begin,
                     end,
                     {components(axes.toP(forcing.torque_B + body.value)), components(axes.toP(body.slope))},
                     {components(forcing.torque_W + space.value), components(space.slope)},
                     {},
                     !forces.empty()};
  addForces(forces, inside, piece);
  return piece;
}

}  // namespace

std::vector<double> forcingTimes(const Forcing& forcing, double end_s) {
  std::vector<double> times = {0, end_s};
  const auto add = [&](double t) {
    if (t > std::min(0.0, end_s) && t < std::max(0.0, end_s)) times.push_back(t);
  };
  for (const TorqueHistory* history : {&forcing.torqueHistory_B, &forcing.torqueHistory_W})
    for (const double t : history->t_s) add(t);
  for (const PointForce& force : forcing.forces) {
    add(force.from_s);
    add(force.to_s);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  if (end_s < 0) std::reverse(times.begin(), times.end());
  return times;
}

Eigen::Vector3d torqueAt(const TorqueHistory& history, double t_s) { return lineOf(history, t_s, t_s).value; }

std::vector<ForcingPiece> forcingPieces(const Forcing& forcing, const PrincipalAxes& axes, double end_s) {
  std::vector<ForcingPiece> pieces;
  if (end_s == 0) return pieces;
  const std::vector<double> times = forcingTimes(forcing, end_s);
  const std::vector<PushingForce> forces = pushingForces(forcing, axes);
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
    pieces.push_back(pieceBetween(forcing, forces, axes, times[i], times[i + 1]));
  return pieces;
}

}  // namespace poinsot::physics
