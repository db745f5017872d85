// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>

namespace poinsot::physics {

/// Free motion computed as in a textbook, with Boost.Math and in double throughout, for a benchmark beside
/// FreeMotion. omega follows Landau & Lifshitz, Mechanics, section 37; the attitude follows Euler angles about M,
/// with
///   phi' = M (I_a Omega_a^2 + I_2 Omega_2^2)/(I_a^2 Omega_a^2 + I_2^2 Omega_2^2)
/// integrated by Legendre's Pi(n; am u, k). Symmetric bodies, steady spins and the separatrix are not supported.
class ClassicalRoute {
 public:
  ClassicalRoute(const Eigen::Vector3d& I, const Eigen::Vector3d& omega0, const Eigen::Quaterniond& q0)
      : I_(I), m0_(I.cwiseProduct(omega0)) {
    const double M2 = m0_.squaredNorm(), twoE = m0_.dot(omega0);
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int i, int j) { return I[i] < I[j]; });
    mid_ = order[1];
    const bool aboutLargest = M2 > twoE * I[mid_];
    c_ = order[aboutLargest ? 2 : 0];
    a_ = order[aboutLargest ? 0 : 2];
    M_ = std::sqrt(M2);
    setPolhode(twoE * I[c_] - M2, M2 - twoE * I[a_]);
    q0_ = q0.normalized() * euler(m0_, 0).conjugate();
  }

  Eigen::Quaterniond at(double t) const {
    const double u = lambda_ * t + u0_;
    double cn = 0, dn = 0;
    const double sn = boost::math::jacobi_elliptic(k_, u, &cn, &dn);
    Eigen::Vector3d m;
    m[a_] = A_a_ * cn;
    m[mid_] = sign2_ * A_2_ * sn;
    m[c_] = signC_ * A_c_ * dn;
    const double phi = M_ / I_[mid_] * t + integral(u, sn, cn) - start_;
    return q0_ * euler(m, phi);
  }

 private:
  void setPolhode(double fromC, double fromA) {
    const double Ia = I_[a_], I2 = I_[mid_], Ic = I_[c_];
    A_a_ = std::sqrt(Ia * fromC / (Ic - Ia));
    A_2_ = std::sqrt(I2 * fromC / (Ic - I2));
    A_c_ = std::sqrt(Ic * fromA / (Ic - Ia));
    lambda_ = std::sqrt((Ic - I2) * fromA / (Ia * I2 * Ic));
    k_ = std::sqrt((I2 - Ia) * fromC / ((Ic - I2) * fromA));
    n_ = 1 - A_2_ * A_2_ / (A_a_ * A_a_);
    signC_ = m0_[c_] < 0 ? -1 : 1;
    sign2_ = signC_ * (I_[(mid_ + 2) % 3] < I_[(mid_ + 1) % 3] ? 1 : -1);
    K_ = boost::math::ellint_1(k_);
    const double sn = sign2_ * m0_[mid_] / A_2_, cn = m0_[a_] / A_a_;
    u0_ = boost::math::ellint_1(k_, std::atan2(sn, cn));
    start_ = integral(u0_, sn, cn);
  }

  /// Returns the integral of phi'/lambda - M/(lambda I_2) over u.
  double integral(double u, double sn, double cn) const {
    const double amplitude = std::atan2(sn, cn) + 2 * std::acos(-1.0) * std::round(u / (4 * K_));
    const double pi = boost::math::ellint_3(k_, n_, amplitude);
    return M_ / lambda_ * (1 / I_[a_] - 1 / I_[mid_]) * (u / n_ - (1 - n_) / n_ * pi);
  }

  /// Returns Rz(phi) Rx(theta) Rz(psi) in the axes x = c + 1, y = c + 2, z = c.
  Eigen::Quaterniond euler(const Eigen::Vector3d& m, double phi) const {
    const double x = m[(c_ + 1) % 3], y = m[(c_ + 2) % 3];
    const auto about = [&](double angle, int axis) {
      return Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit((c_ + axis) % 3));
    };
    return about(phi, 0) * about(std::atan2(std::hypot(x, y), m[c_]), 1) * about(std::atan2(x, y), 0);
  }

  Eigen::Vector3d I_, m0_;
  Eigen::Quaterniond q0_;
  int a_ = 0, mid_ = 1, c_ = 2;
  double M_ = 0, A_a_ = 0, A_2_ = 0, A_c_ = 0, lambda_ = 0, k_ = 0, n_ = 0, K_ = 0, u0_ = 0, start_ = 0;
  double sign2_ = 1, signC_ = 1;
};

}  // namespace poinsot::physics
