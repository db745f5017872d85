// SPDX-License-Identifier: Apache-2.0
#include "physics/principal_axes.h"

#include <array>

#include "physics/rotor.h"

namespace poinsot::physics {
namespace {

// Not Eigen's rotation: its last bit depends on the vector unit compiled for.
Eigen::Vector3d rotatedBy(const Eigen::Quaterniond& q, double sense, const Eigen::Vector3d& v) {
  const auto r =
      rotated(Rotor<double>{q.w(), sense * q.x(), sense * q.y(), sense * q.z()}, std::array{v[0], v[1], v[2]});
  return {r[0], r[1], r[2]};
}

}  // namespace

PrincipalAxes::PrincipalAxes(const PrincipalMoments& moments, const Eigen::Quaterniond& q_BP)
    : moments_(moments), q_BP_(q_BP), aligned_(q_BP.vec().isZero(0)) {}

Eigen::Vector3d PrincipalAxes::toP(const Eigen::Vector3d& v_B) const {
  return aligned_ ? v_B : rotatedBy(q_BP_, -1, v_B);
}

Eigen::Vector3d PrincipalAxes::toB(const Eigen::Vector3d& v_P) const {
  return aligned_ ? v_P : rotatedBy(q_BP_, 1, v_P);
}

Eigen::Vector3d PrincipalAxes::angularMomentum(const Eigen::Vector3d& omega_B) const {
  return toB(moments_.angularMomentum(toP(omega_B)));
}

Eigen::Vector3d PrincipalAxes::angularVelocity(const Eigen::Vector3d& m_B) const {
  return toB(toP(m_B).cwiseQuotient(moments_.values()));
}

Eigen::Matrix3d PrincipalAxes::inertia_B() const {
  const Eigen::Matrix3d R_BP = q_BP_.toRotationMatrix();
  return R_BP * moments_.values().asDiagonal() * R_BP.transpose();
}

}  // namespace poinsot::physics
