// SPDX-License-Identifier: Apache-2.0
#include "reference/grade_state.h"

#include <cmath>

namespace poinsot::reference {
namespace {

using Eigen::Vector3d;
using physics::Quaternion;

std::optional<Vector3d> vectorAt(const TrajectoryTable& theirs, std::size_t row, TrajectoryPlace place) {
  if (!theirs.has(place)) return std::nullopt;
  return Vector3d(theirs.at(row, place), theirs.at(row, place + 1), theirs.at(row, place + 2));
}

void readAttitude(LoggedState& state, const TrajectoryTable& theirs, std::size_t row) {
  if (!theirs.has(kQAt)) return;
  const Quaternion q(theirs.at(row, kQAt), theirs.at(row, kQAt + 1), theirs.at(row, kQAt + 2),
                     theirs.at(row, kQAt + 3));
  state.quaternionLength = q.coeffs().stableNorm();
  state.q_WB = Quaternion(q.coeffs() / state.quaternionLength);
}

}  // namespace

LoggedState loggedState(const TrajectoryTable& theirs, std::size_t row) {
  LoggedState state;
  state.t_s = theirs.t_s(row);
  readAttitude(state, theirs, row);
  state.omega_B = vectorAt(theirs, row, kOmegaBAt);
  state.omega_W = vectorAt(theirs, row, kOmegaWAt);
  state.rate_B = vectorAt(theirs, row, kRateBAt);
  state.rate_W = vectorAt(theirs, row, kRateWAt);
  state.L_W = vectorAt(theirs, row, kLWAt);
  if (theirs.has(kEnergyAt)) state.kineticEnergy = theirs.at(row, kEnergyAt);
  return state;
}

bool isFinite(const LoggedState& s) {
  const auto finite = [](const std::optional<Vector3d>& v) { return !v || v->allFinite(); };
  return (!s.q_WB || s.q_WB->coeffs().allFinite()) && finite(s.omega_B) && finite(s.omega_W) && finite(s.rate_B) &&
         finite(s.rate_W) && finite(s.L_W) && std::isfinite(s.kineticEnergy.value_or(0));
}

DerivedState derivedState(const physics::PrincipalAxes& axes, const LoggedState& state) {
  DerivedState derived;
  std::optional<Vector3d> omega_B = state.omega_B;
  if (!omega_B && state.omega_W && state.q_WB) omega_B = state.q_WB->conjugate() * *state.omega_W;
  if (omega_B) {
    const Vector3d m_B = axes.angularMomentum(*omega_B);
    derived.lengthOfL = m_B.norm();
    derived.kineticEnergy = 0.5 * omega_B->dot(m_B);
    if (state.q_WB) derived.L_W = *state.q_WB * m_B;
  }
  if (state.L_W) {
    derived.L_W = state.L_W;
    derived.lengthOfL = state.L_W->norm();
  }
  if (state.kineticEnergy) derived.kineticEnergy = state.kineticEnergy;
  return derived;
}

double angleBetween(const Quaternion& a, const Quaternion& b) {
  const Quaternion d = a.conjugate() * b;
  return 2 * std::atan2(d.vec().norm(), std::abs(d.w()));
}

double angleBetween(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace poinsot::reference
