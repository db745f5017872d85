// SPDX-License-Identifier: Apache-2.0
#include "physics/forcing_piece.h"

#include <algorithm>

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

std::vector<double> boundaries(const Forcing& forcing, double end_s) {
  std::vector<double> times = {0, end_s};
  for (const TorqueHistory* history : {&forcing.torqueHistory_B, &forcing.torqueHistory_W})
    for (const double t : history->t_s)
      if (t > std::min(0.0, end_s) && t < std::max(0.0, end_s)) times.push_back(t);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  if (end_s < 0) std::reverse(times.begin(), times.end());
  return times;
}

ForcingPiece pieceBetween(const Forcing& forcing, const PrincipalAxes& axes, double begin, double end) {
  const double inside = begin + 0.5 * (end - begin);
  const Line body = lineOf(forcing.torqueHistory_B, inside, begin);
  const Line space = lineOf(forcing.torqueHistory_W, inside, begin);
  return {begin,
          end,
          {components(axes.toP(forcing.torque_B + body.value)), components(axes.toP(body.slope))},
          {components(forcing.torque_W + space.value), components(space.slope)}};
}

}  // namespace

Eigen::Vector3d torqueAt(const TorqueHistory& history, double t_s) { return lineOf(history, t_s, t_s).value; }

std::vector<ForcingPiece> forcingPieces(const Forcing& forcing, const PrincipalAxes& axes, double end_s) {
  std::vector<ForcingPiece> pieces;
  if (end_s == 0) return pieces;
  const std::vector<double> times = boundaries(forcing, end_s);
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
    pieces.push_back(pieceBetween(forcing, axes, times[i], times[i + 1]));
  return pieces;
}

}  // namespace poinsot::physics
