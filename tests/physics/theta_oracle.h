// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <boost/math/special_functions/ellint_1.hpp>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "physics/theta_series.h"

namespace poinsot::physics {

using Vector100 = std::array<Real100, 3>;
using Matrix100 = std::array<Vector100, 3>;  // rows

/// Free rotation by the textbooks' formulas with 100 digits. Shares no formula of the attitude with the code under
/// test, and costs the same at any time.
///
///   omega by Landau & Lifshitz, Mechanics, section 37 (modulus k, not its complement; 2 E I - M^2 as differences)
///   attitude by Euler angles about M: tan psi and cos theta from m, and phi from the theta functions of Jacobi,
///     phi = kappa u + rho arg theta_1(pi (u - i eta)/(2K)),   sn(i eta) = i A_a/sqrt(A_2^2 - A_a^2)
///   (Jacobi, Crelle 39 (1850) 293; van Zon & Schofield, J. Comput. Phys. 225 (2007) 145). kappa is such that
///   phi' at u = 0 is M/I_a, and phi enters by its cosine and sine alone, so no angle is ever unwrapped.
///
/// Rejects the separatrix itself, where K is infinite. theta_oracle_test.cpp compares this class with the Taylor
/// integrator.
class ThetaOracle {
 public:
  using Real = Real100;

  struct State {
    Vector100 omega;
    Matrix100 R;  // takes body components to those of W
  };

  ThetaOracle(const Eigen::Vector3d& I, const Eigen::Vector3d& omega0, const Eigen::Quaterniond& q0)
      : ThetaOracle(I, omega0, rotationMatrix(q0)) {}

  /// Constructs the oracle from a start R0 that is exact to 100 digits.
  ThetaOracle(const Eigen::Vector3d& I, const Eigen::Vector3d& omega0, const Matrix100& R0) {
    for (std::size_t i = 0; i < 3; ++i) {
      I_[i] = I[static_cast<int>(i)];
      omega0_[i] = omega0[static_cast<int>(i)];
    }
    R0_ = R0;
    steady_ = isSteady();
    if (!steady_) setConstants();
  }

  State at(const Real& t) const {
    if (steady_) return {omega0_, product(R0_, spin(t))};
    const Real u = lambda_ * t + u0_;
    const Vector100 m = momentum(u);
    Vector100 omega;
    for (std::size_t i = 0; i < 3; ++i) omega[i] = m[i] / I_[i];
    return {omega, product(R0_, product(transposed(eulerMatrix(m0_, 1, 0)), turned(m, u, t)))};
  }

  /// Returns the largest |omega| of the whole motion, rad/s. |omega|^2 is linear in sn^2 u, so largest at u = 0 or
  /// u = K.
  double largestOmega() const {
    const auto squared = [](const Real& x) { return Real(x * x); };
    if (steady_) return std::sqrt(static_cast<double>(Real(dot(omega0_, omega0_))));
    const Real at0 = squared(A_a_ / I_[a_]) + squared(A_c_ / I_[c_]);
    const Real atK = squared(A_2_ / I_[mid_]) + (1 - k2_) * squared(A_c_ / I_[c_]);
    return static_cast<double>(Real(sqrt(at0 > atK ? at0 : atK)));
  }

  Vector100 momentum_W() const {
    Vector100 m;
    for (std::size_t i = 0; i < 3; ++i) m[i] = I_[i] * omega0_[i];
    return product(R0_, m);
  }
  Real twiceEnergy() const {
    return I_[0] * omega0_[0] * omega0_[0] + I_[1] * omega0_[1] * omega0_[1] + I_[2] * omega0_[2] * omega0_[2];
  }

  /// Returns the angle in rad between the attitude R and the tested attitude, without the rounding of a
  /// subtraction.
  static double angle(const Matrix100& R, const Eigen::Quaterniond& tested) {
    const Matrix100 D = product(transposed(R), rotationMatrix(tested));
    const Real x = D[2][1] - D[1][2], y = D[0][2] - D[2][0], z = D[1][0] - D[0][1];
    const double twiceSine = std::sqrt(static_cast<double>(Real(x * x + y * y + z * z)));
    return std::atan2(twiceSine, static_cast<double>(Real(D[0][0] + D[1][1] + D[2][2] - 1)));
  }

  static double distance(const Vector100& expected, const Eigen::Vector3d& tested) {
    Real square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Real d = expected[i] - Real(tested[static_cast<int>(i)]);
      square += d * d;
    }
    return static_cast<double>(Real(sqrt(square)));
  }

  /// Returns the rotation matrix of any nonzero quaternion.
  static Matrix100 rotationMatrix(const Eigen::Quaterniond& q) {
    return rotationMatrix({Real(q.w()), Real(q.x()), Real(q.y()), Real(q.z())});
  }
  static Matrix100 rotationMatrix(const std::array<Real, 4>& q) {
    const auto& [w, x, y, z] = q;
    const Real s = 2 / (w * w + x * x + y * y + z * z);
    return {Vector100{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
            Vector100{s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)},
            Vector100{s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)}};
  }

  static Real dot(const Vector100& v, const Vector100& w) { return v[0] * w[0] + v[1] * w[1] + v[2] * w[2]; }

  static Matrix100 product(const Matrix100& A, const Matrix100& B) {
    Matrix100 C;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) C[i][j] = A[i][0] * B[0][j] + A[i][1] * B[1][j] + A[i][2] * B[2][j];
    return C;
  }

  static Vector100 product(const Matrix100& A, const Vector100& v) {
    return {dot(A[0], v), dot(A[1], v), dot(A[2], v)};
  }

  static Matrix100 transposed(const Matrix100& A) {
    Matrix100 result;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) result[i][j] = A[j][i];
    return result;
  }

 private:
  /// Returns whether omega is parallel to I omega.
  bool isSteady() const {
    const auto couples = [&](std::size_t j, std::size_t k) {
      return I_[j] != I_[k] && omega0_[j] != 0 && omega0_[k] != 0;
    };
    return !couples(0, 1) && !couples(1, 2) && !couples(0, 2);
  }

  Matrix100 spin(const Real& t) const {
    const Real rate = sqrt(dot(omega0_, omega0_));
    const Real half = rate * t / 2, s = rate == 0 ? Real(0) : Real(sin(half) / rate);
    return rotationMatrix({cos(half), s * omega0_[0], s * omega0_[1], s * omega0_[2]});
  }

  void setConstants() {
    std::array<std::size_t, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return I_[i] < I_[j]; });
    Real M2 = 0, twoE = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      m0_[i] = I_[i] * omega0_[i];
      M2 += m0_[i] * m0_[i];
      twoE += m0_[i] * omega0_[i];
    }
    mid_ = order[1];
    const Real side = M2 - twoE * I_[mid_];
    if (side == 0) throw std::invalid_argument("ThetaOracle: on the separatrix");
    c_ = side > 0 ? order[2] : order[0];
    a_ = side > 0 ? order[0] : order[2];
    rho_ = side > 0 ? 1 : -1;
    setPolhode(M2, twoE);
    setPhi(sqrt(M2));
  }

  void setPolhode(const Real& M2, const Real& twoE) {
    const Real &Ia = I_[a_], &I2 = I_[mid_], &Ic = I_[c_];
    const Real fromC = twoE * Ic - M2, fromA = M2 - twoE * Ia;
    M_ = sqrt(M2);
    A_a_ = sqrt(Real(Ia * fromC / (Ic - Ia)));
    A_2_ = sqrt(Real(I2 * fromC / (Ic - I2)));
    A_c_ = sqrt(Real(Ic * fromA / (Ic - Ia)));
    lambda_ = sqrt(Real((Ic - I2) * fromA / (Ia * I2 * Ic)));
    k2_ = (I2 - Ia) * fromC / ((Ic - I2) * fromA);
    // Euler's equations give m_2' = m_j m_k (1/I_k - 1/I_j), with (2, j, k) cyclic, which has the sign of cn dn.
    const std::size_t j = (mid_ + 1) % 3, k = (mid_ + 2) % 3;
    signC_ = m0_[c_] < 0 ? -1 : 1;
    sign2_ = signC_ * (I_[k] < I_[j] ? 1 : -1);
    const Real k1 = sqrt(k2_), kPrime = sqrt(Real(1 - k2_));
    K_ = quarterPeriod(kPrime);
    u0_ = boost::math::ellint_1(k1, Real(atan2(Real(sign2_ * m0_[mid_] / A_2_), Real(m0_[a_] / A_a_))));
    if (k2_ == 0) return;
    const Real pi = boost::math::constants::pi<Real>();
    theta_.emplace(exp(Real(-pi * quarterPeriod(k1) / K_)));
    const Real eta = boost::math::ellint_1(kPrime, Real(atan2(A_a_, Real(sqrt(Real(A_2_ * A_2_ - A_a_ * A_a_))))));
    w_ = pi * eta / (2 * K_);
  }

  /// Returns K of the modulus with this complement k', pi/(2 AGM(1, k')).
  static Real quarterPeriod(const Real& complement) {
    Real a = 1, b = complement;
    for (int i = 0; i < 40 && abs(Real(a - b)) > a * Real("1e-60"); ++i) {
      const Real mean = (a + b) / 2;
      b = sqrt(Real(a * b));
      a = mean;
    }
    return boost::math::constants::pi<Real>() / (a + b);
  }

  void setPhi(const Real& M) {
    kappa_ = M / (lambda_ * I_[a_]);
    if (theta_) kappa_ -= rho_ * logarithmicSlope();
    start_ = phaseFactor(u0_);
  }

  Real angleOf(const Real& u) const { return boost::math::constants::half_pi<Real>() * u / K_; }

  /// Returns d arg theta_1(v - i w)/du at u = 0, where theta_1 is imaginary.
  Real logarithmicSlope() const {
    const auto f = theta_->first(0, w_);
    return -f.slope.re / f.value.im * angleOf(1);
  }

  /// Returns theta_1(v - i w)^rho, scaled to unit length.
  ThetaSeries::Complex phaseFactor(const Real& u) const {
    if (!theta_) return {1, 0};
    const ThetaSeries::Complex f = theta_->first(angleOf(u), w_).value;
    const Real size = sqrt(Real(f.re * f.re + f.im * f.im));
    return {f.re / size, rho_ * f.im / size};
  }

  Vector100 momentum(const Real& u) const {
    const Real v = angleOf(u);
    const std::array<Real, 3> f =
        theta_ ? theta_->jacobi(v) : std::array<Real, 3>{Real(sin(u)), Real(cos(u)), Real(1)};
    Vector100 m;
    m[a_] = A_a_ * f[1];
    m[mid_] = sign2_ * A_2_ * f[0];
    m[c_] = signC_ * A_c_ * f[2];
    return m;
  }

  /// Returns Rz(phi) Rx(theta) Rz(psi) at phase u, with phi counted from the start.
  Matrix100 turned(const Vector100& m, const Real& u, const Real& t) const {
    const Real secular = kappa_ * lambda_ * t;
    const ThetaSeries::Complex now = phaseFactor(u);
    const Real c = now.re * start_.re + now.im * start_.im, s = now.im * start_.re - now.re * start_.im;
    const Real cosine = cos(secular), sine = sin(secular);
    return eulerMatrix(m, c * cosine - s * sine, s * cosine + c * sine);
  }

  /// Returns Rz(phi) Rx(theta) Rz(psi) for body components along the axes x = c + 1, y = c + 2, z = c, where
  ///   m_x = M sin theta sin psi,   m_y = M sin theta cos psi,   m_z = M cos theta.
  Matrix100 eulerMatrix(const Vector100& m, const Real& cosPhi, const Real& sinPhi) const {
    const std::size_t x = (c_ + 1) % 3, y = (c_ + 2) % 3;
    const Real across = sqrt(Real(m[x] * m[x] + m[y] * m[y]));
    const Real cosTheta = m[c_] / M_, sinTheta = across / M_, sinPsi = m[x] / across, cosPsi = m[y] / across;
    Matrix100 R;
    const auto setColumns = [&](std::size_t row, const Real& X, const Real& Y, const Real& Z) {
      R[row][x] = X;
      R[row][y] = Y;
      R[row][c_] = Z;
    };
    setColumns(0, cosPhi * cosPsi - sinPhi * cosTheta * sinPsi, -cosPhi * sinPsi - sinPhi * cosTheta * cosPsi,
               sinPhi * sinTheta);
    setColumns(1, sinPhi * cosPsi + cosPhi * cosTheta * sinPsi, -sinPhi * sinPsi + cosPhi * cosTheta * cosPsi,
               -cosPhi * sinTheta);
    setColumns(2, sinTheta * sinPsi, sinTheta * cosPsi, cosTheta);
    return R;
  }

  Vector100 I_, omega0_, m0_;
  Matrix100 R0_;
  bool steady_ = false;
  std::size_t a_ = 0, mid_ = 1, c_ = 2;
  int rho_ = 1, sign2_ = 1, signC_ = 1;
  Real M_, A_a_, A_2_, A_c_, lambda_, k2_, K_, u0_, w_, kappa_;
  std::optional<ThetaSeries> theta_;  // empty for a symmetric body, k = 0
  ThetaSeries::Complex start_;
};

}  // namespace poinsot::physics
