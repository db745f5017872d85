// SPDX-License-Identifier: Apache-2.0
#include "physics/free_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/expect.h"
#include "physics/elliptic.h"
#include "physics/free_motion_constants.h"
#include "physics/rotor.h"
#include "physics/transcendental.h"

// Closed form of the free rotation. In the body, m = I omega runs along its polhode as Jacobi functions of u =
// lambda t + u0 (free_motion_constants.h). F(u) is the node frame of m in body axes: z is along m, and x is along
// the node line e_c × m. L is fixed in space, so that F turns about L by an angle phi alone:
//
//   R(t) = R0 F(u0) Rz(phi) F(u)^-1,       phi = (L/I2) t + s [H(u) - H(u0)]
//   H(u) = atan(p sn cn / dn) + p (mc/(3g)) sn^3 R_J(cn^2, dn^2, 1, cn^2 + (mc/g) sn^2)      |u| <= K
//   H(u + 2K) = H(u) + 2Q
//
// phi' = L (A_a^2 cn^2/I_a + A_2^2 sn^2/I_2)/(A_a^2 cn^2 + A_2^2 sn^2) is a weighted mean of L/I_a and L/I_2.
// L/I_2 is split off, because |omega - (L/I_2) L^| <= lambda for every body and start: an error du of the phase
// then changes the attitude by at most du (docs/derivations.md). Textbooks split off L/I_a or L/I_c, whose
// remainder can turn much faster than lambda: near the separatrix, for near-spheres and for rods. The arctangent
// is the half turn of the node line near the middle axis; its coefficient is exactly 1. The R_J term is a sum of
// positive terms.
//
// All quantities that grow with t, which are (L/I2) t, u and N Q, have about 100 bits until they are reduced. All
// other quantities are doubles. Verified in tests/physics/free_motion_oracle_test.cpp (Taylor integrator, 34 and
// 60 digits).

namespace poinsot::physics {
namespace {

/// Values of sn, cn and dn at the reduced phase. After an odd number of half periods, `halfTurn` is -1, which
/// changes the sign of m_a and m_2.
struct PolhodePoint {
  SnCnDn f;
  double halfTurn = 1;
};

/// Converts components along the sorted axes to the node axes x, y, z, of which z is axis c. The axes are permuted
/// cyclically.
template <typename T>
std::array<T, 3> toNodeAxes(const std::array<T, 3>& v, std::size_t c) {
  return {v[(c + 1) % 3], v[(c + 2) % 3], v[c]};
}

template <typename T>
std::array<T, 3> fromNodeAxes(const std::array<T, 3>& v, std::size_t c) {
  std::array<T, 3> sorted;
  sorted[(c + 1) % 3] = v[0];
  sorted[(c + 2) % 3] = v[1];
  sorted[c] = v[2];
  return sorted;
}

bool isOdd(double integer) { return std::fmod(integer, 2) != 0; }

Rotor<double> aboutZ(const SineCosine& half) { return {half.cosine, 0, 0, half.sine}; }

/// Normalizes a quaternion of any nonzero length, accurate to 106 bits.
Rotor<DoubleDouble> unitRotor(const Quaternion& q) {
  const double largest = q.coeffs().cwiseAbs().maxCoeff();
  if (!q.coeffs().allFinite() || largest == 0)
    throw core::physicsError(fmt::format("orientation must be a nonzero, finite quaternion, got ({}, {}, {}, {})",
                                         q.w(), q.x(), q.y(), q.z()));
  const int exponent = exponentOf(largest);
  const auto nearOne = [&](double v) { return DoubleDouble(std::ldexp(v, -exponent)); };
  return normalized(Rotor<DoubleDouble>{nearOne(q.w()), nearOne(q.x()), nearOne(q.y()), nearOne(q.z())});
}

}  // namespace

struct FreeMotion::Solution {
  Solution(const PrincipalAxes& axes_, const Eigen::Vector3d& omega0_B, const Quaternion& q0);

  RigidBodyState at(double t_s) const;
  bool reaches(double tau) const { return std::abs(tau) * fastest_ <= kFarthestPhase_rad; }

  PrincipalAxes axes;
  FreeMotionConstants k;
  JacobiFunctions jacobi;
  Rotor<double> q0_WP;
  Eigen::Vector3d L_W;
  double kineticEnergy = 0;

 private:
  // Rotation of the body since t = 0, and its angular velocity, both along the sorted axes.
  struct Relative {
    Rotor<double> q;
    std::array<double, 3> omega;
  };

  void setStart();
  Quaternion attitude_B(Rotor<double> q_WP) const;
  Relative steadyAt(double tau) const;
  Relative movingAt(double tau) const;
  std::array<double, 3> momentum(const PolhodePoint& point) const;
  double H(const SnCnDn& f) const;

  // Members p, mc/(3g) and mc/g of `k`, rounded to double.
  double p_ = 0, mcOver3g_ = 0, mcOverG_ = 0;
  DoubleDouble meanRate_;  // mean rate of phi: L/I2, or |omega| of a steady spin
  double fastest_ = 0;     // largest rate of all phases
  DoubleDouble twoK_, twoQ_;
  std::array<double, 3> amplitude_{};  // signed amplitudes of m along the sorted axes
  Rotor<double> frame0_;               // node frame at the start, F(u0)
  double N0_ = 0, H0_ = 0;             // number of half periods in u0, and H of the rest of u0
};

FreeMotion::Solution::Solution(const PrincipalAxes& axes_, const Eigen::Vector3d& omega0_B, const Quaternion& q0)
    : axes(axes_),
      k(freeMotionConstants(axes_.moments(), axes_.toP(omega0_B))),
      jacobi(k.periodic() ? k.mc : DoubleDouble(0)) {
  using DD = DoubleDouble;
  Rotor<DD> q0_exact = unitRotor(q0);
  if (!axes.aligned()) q0_exact = q0_exact * unitRotor(axes.q_BP());
  q0_WP = toDouble(q0_exact);
  std::array<DD, 3> m0_P;
  for (std::size_t i = 0; i < 3; ++i)
    m0_P[static_cast<std::size_t>(k.start.axis[i])] = twoProduct(k.start.I[i], k.start.parity * k.start.omega[i]);
  const std::array<DD, 3> m0_W = rotated(q0_exact, m0_P);
  const int exponent = k.start.momentExponent + k.start.rateExponent;
  for (int i = 0; i < 3; ++i) L_W[i] = std::ldexp(toDouble(m0_W[static_cast<std::size_t>(i)]), exponent);
  kineticEnergy = std::ldexp(toDouble(k.twoT), exponent + k.start.rateExponent - 1);
  if (!L_W.allFinite() || !std::isfinite(kineticEnergy))
    throw core::physicsError("angular momentum or energy is beyond the range of numbers");
  setStart();
}

void FreeMotion::Solution::setStart() {
  using DD = DoubleDouble;
  const auto& I = k.start.I;
  const auto& w = k.start.omega;
  if (k.regime == PolhodeRegime::kSteady) {
    meanRate_ = sqrt(twoProduct(w[0], w[0]) + twoProduct(w[1], w[1]) + twoProduct(w[2], w[2]));
    fastest_ = toDouble(meanRate_);
    return;
  }
  meanRate_ = k.L / I[1];
  fastest_ = std::max({1.0, toDouble(meanRate_), toDouble(k.lambda)});  // in scaled units, |omega| is about 1
  twoK_ = k.K * 2.0;
  twoQ_ = k.Q * (2.0 * k.s);
  p_ = toDouble(k.p);
  mcOverG_ = toDouble(k.mc / k.g);
  mcOver3g_ = toDouble(k.mc / (k.g * 3.0));
  amplitude_[k.a] = k.sigmaA * toDouble(k.A_a);
  amplitude_[1] = k.sigma * k.sigmaA * toDouble(k.A_2);
  amplitude_[k.c] = k.sigma * toDouble(k.A_c);
  const auto m0 =
      toNodeAxes(std::array<DD, 3>{twoProduct(I[0], w[0]), twoProduct(I[1], w[1]), twoProduct(I[2], w[2])}, k.c);
  frame0_ = toDouble(nodeFrame(m0[0], m0[1], m0[2]));
  N0_ = k.periodic() ? reduced(k.u0, twoK_).multiple : 0;
  // H0_ is computed from sn u0, not from the rounded u0, because frame0_ belongs to the exact start, too. An error
  // is a harmless shift of the phase only if both have the same error.
  const double sign = isOdd(N0_) ? -1 : 1;
  H0_ = H({sign * toDouble(k.sn0), sign * toDouble(k.cn0), toDouble(sqrt(k.cn0 * k.cn0 + k.mc * k.sn0 * k.sn0))});
}

double FreeMotion::Solution::H(const SnCnDn& f) const {
  const double quotient = f.dn == 0 ? 1 : f.cn / f.dn;  // on the separatrix, cn = dn = sech u may underflow
  const double turn = arcTangent(p_ * f.sn * quotient);
  if (mcOver3g_ == 0 || p_ == 0) return turn;
  const double cn2 = f.cn * f.cn, sn2 = f.sn * f.sn;
  return turn + p_ * f.sn * sn2 * (mcOver3g_ * carlsonRJ(cn2, f.dn * f.dn, 1, cn2 + mcOverG_ * sn2));
}

std::array<double, 3> FreeMotion::Solution::momentum(const PolhodePoint& point) const {
  std::array<double, 3> m{};
  m[k.a] = point.halfTurn * amplitude_[k.a] * point.f.cn;
  m[1] = point.halfTurn * amplitude_[1] * point.f.sn;
  m[k.c] = amplitude_[k.c] * point.f.dn;
  return m;
}

FreeMotion::Solution::Relative FreeMotion::Solution::movingAt(double tau) const {
  const DoubleDouble u = k.lambda * tau + k.u0;
  const Reduced phase = k.periodic() ? reduced(u, twoK_) : Reduced{u, 0};
  const PolhodePoint point{jacobi.at(phase.rest.hi), isOdd(phase.multiple) ? -1.0 : 1.0};
  const DoubleDouble secular = reduced(meanRate_ * tau + twoQ_ * (phase.multiple - N0_), kTwoPi).rest;
  const DoubleDouble phi = secular + DoubleDouble(k.s) * (DoubleDouble(H(point.f)) - H0_);
  const std::array<double, 3> m = momentum(point);
  const auto node = toNodeAxes(m, k.c);
  const Rotor<double> turned = frame0_ * aboutZ(sineCosine(phi * 0.5));
  const Rotor<double> q = turned * conjugate(nodeFrame(node[0], node[1], node[2]));
  const auto axis = fromNodeAxes(std::array{q.x, q.y, q.z}, k.c);
  return {{q.w, axis[0], axis[1], axis[2]}, {m[0] / k.start.I[0], m[1] / k.start.I[1], m[2] / k.start.I[2]}};
}

FreeMotion::Solution::Relative FreeMotion::Solution::steadyAt(double tau) const {
  const auto& w = k.start.omega;
  const double rate = toDouble(meanRate_);
  if (rate == 0) return {{}, w};
  const SineCosine half = sineCosine(reduced(meanRate_ * tau, kTwoPi).rest * 0.5);
  const double s = half.sine;
  return {{half.cosine, s * w[0] / rate, s * w[1] / rate, s * w[2] / rate}, w};
}

Quaternion FreeMotion::Solution::attitude_B(Rotor<double> q) const {
  if (!axes.aligned()) {
    const Quaternion& q_BP = axes.q_BP();
    q = normalized(q * Rotor<double>{q_BP.w(), -q_BP.x(), -q_BP.y(), -q_BP.z()});
  }
  if (q.w < 0) q = {-q.w, -q.x, -q.y, -q.z};
  return {q.w, q.x, q.y, q.z};
}

RigidBodyState FreeMotion::Solution::at(double t_s) const {
  const double tau = std::ldexp(t_s, k.start.rateExponent);
  if (!reaches(tau)) refuseTime(t_s);
  const Relative relative = k.regime == PolhodeRegime::kSteady ? steadyAt(tau) : movingAt(tau);
  const Eigen::Vector3d axis_P = k.start.toP({relative.q.x, relative.q.y, relative.q.z});
  const Rotor<double> q_WP = normalized(q0_WP * Rotor<double>{relative.q.w, axis_P[0], axis_P[1], axis_P[2]});
  const Eigen::Vector3d omega_P = k.start.toP(relative.omega);
  const auto omega_W = rotated(q_WP, std::array{omega_P[0], omega_P[1], omega_P[2]});
  const auto rescaled = [&](double v) { return std::ldexp(v, k.start.rateExponent); };
  RigidBodyState state;
  state.t_s = t_s;
  state.q_WB = attitude_B(q_WP);
  state.omega_B = axes.toB(omega_P).unaryExpr(rescaled);
  state.omega_W = {rescaled(omega_W[0]), rescaled(omega_W[1]), rescaled(omega_W[2])};
  state.L_W = L_W;
  state.kineticEnergy = kineticEnergy;
  return state;
}

FreeMotion::FreeMotion(const PrincipalAxes& axes, const Eigen::Vector3d& omega0_B, const Quaternion& q0_WB)
    : solution_(std::make_unique<const Solution>(axes, omega0_B, q0_WB)) {}

FreeMotion::~FreeMotion() = default;
FreeMotion::FreeMotion(FreeMotion&&) noexcept = default;
FreeMotion& FreeMotion::operator=(FreeMotion&&) noexcept = default;

const FreeMotion::Solution& FreeMotion::solution() const {
  POINSOT_EXPECT(solution_ != nullptr);
  return *solution_;
}

RigidBodyState FreeMotion::at(double t_s) const { return solution().at(t_s); }
bool FreeMotion::reaches(double t_s) const {
  return solution().reaches(std::ldexp(t_s, solution().k.start.rateExponent));
}

const PrincipalAxes& FreeMotion::axes() const { return solution().axes; }
const Eigen::Vector3d& FreeMotion::L_W() const { return solution().L_W; }
double FreeMotion::kineticEnergy() const { return solution().kineticEnergy; }

}  // namespace poinsot::physics
