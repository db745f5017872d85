// SPDX-License-Identifier: Apache-2.0
#include "physics/principal_moments.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "physics/inertia_tensor.h"

namespace poinsot::physics {
namespace {

[[noreturn]] void refuse(const Eigen::Vector3d& I, const char* reason) {
  throw core::physicsError(fmt::format("{}, got ({}, {}, {}) kg·m²", reason, I[0], I[1], I[2]));
}

}  // namespace

PrincipalMoments::PrincipalMoments(double I1, double I2, double I3) : moments_(I1, I2, I3) { check(); }

void PrincipalMoments::check() const {
  if (!moments_.allFinite()) refuse(moments_, "principal moments must be finite");
  if (moments_.minCoeff() <= 0) refuse(moments_, "principal moments must be positive");
  const double largest = moments_.maxCoeff();
  const Eigen::Vector3d scaled = moments_ / largest;  // scaled, so that their sum cannot overflow
  if (1.0 > (scaled[0] + scaled[1] + scaled[2] - 1.0) * (1 + kTensorSlack))
    refuse(moments_, "no moment may exceed the sum of the other two (a solid body cannot have these values)");
}

std::array<int, 3> PrincipalMoments::ascendingAxes() const {
  std::array<int, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return moments_[a] < moments_[b]; });
  return axes;
}

Eigen::Vector3d PrincipalMoments::angularMomentum(const Eigen::Vector3d& omega_P) const {
  return moments_.cwiseProduct(omega_P);
}

double PrincipalMoments::kineticEnergy(const Eigen::Vector3d& omega_P) const {
  const Eigen::Vector3d twice = moments_.cwiseProduct(omega_P).cwiseProduct(omega_P);
  return 0.5 * (twice[0] + twice[1] + twice[2]);  // not Eigen's dot(), whose order depends on the vector unit
}

}  // namespace poinsot::physics
