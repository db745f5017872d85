// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "physics/free_motion.h"
#include "physics/polhode.h"
#include "physics/residual.h"
#include "physics/taylor_oracle.h"

// Motion at very long times, compared with an integrator of 60 digits. After one period Tp of omega in the body,
// the attitude has gained a fixed rotation: q(t + Tp) = M q(t), M = q(Tp) q(0)^-1. Thus q(n Tp + r) = M^n q(r),
// and one period integrated to 60 digits gives the attitude at any t. Newton's method on the integrator refines
// Tp, so that no elliptic function enters the expected value. Measured: at most 6.1e-16 rad, and 3.1e-16 of omega.

namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Oracle = TaylorOracle<Real60>;

class PeriodicOracle {
 public:
  PeriodicOracle(const Vector3d& I, const Vector3d& omega0, const Quaterniond& q0, double periodGuess_s)
      : oracle_(I, omega0, q0) {
    Oracle::State state = oracle_.at(Real60(periodGuess_s));
    period_ = periodGuess_s;
    for (int i = 0; i < 3; ++i) {  // the error squares: 1e-15, 1e-30, 1e-60
      const Real60 correction = timeTo(oracle_.start().omega, state);
      state = oracle_.advanced(state, correction);
      period_ += correction;
    }
    gain_ = Oracle::product(state.q, inverse(oracle_.start().q));
  }

  const Real60& period() const { return period_; }

  Oracle::State at(double t_s) const {
    Real60 periods = floor(Real60(t_s) / period_);
    Oracle::State state = oracle_.at(Real60(t_s) - periods * period_);
    state.q = Oracle::unit(Oracle::product(power(gain_, periods), state.q));
    return state;
  }

 private:
  /// Returns Newton's estimate of the time from `state` to the nearby point `omega` of its polhode.
  Real60 timeTo(const std::array<Real60, 3>& omega, const Oracle::State& state) const {
    const auto rate = oracle_.derivative(state);
    Real60 along = 0, square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      along += (omega[i] - state.omega[i]) * rate[i];
      square += rate[i] * rate[i];
    }
    return along / square;
  }

  static std::array<Real60, 4> inverse(const std::array<Real60, 4>& q) { return {q[0], -q[1], -q[2], -q[3]}; }

  static std::array<Real60, 4> power(std::array<Real60, 4> base, Real60 n) {
    if (n < 0) return power(inverse(base), -n);
    std::array<Real60, 4> result = {1, 0, 0, 0};
    for (; n > 0; n = floor(n / 2)) {
      if (n - 2 * floor(n / 2) == 1) result = Oracle::product(result, base);
      base = Oracle::unit(Oracle::product(base, base));
    }
    return result;
  }

  Oracle oracle_;
  Real60 period_;
  std::array<Real60, 4> gain_;
};

void expectAtLongTimes(const char* name, const Vector3d& I, const Vector3d& omega0,
                       std::initializer_list<double> times) {
  const Quaterniond q0(0.5, -0.25, 0.75, 1.5);
  const PrincipalMoments moments(I);
  const FreeMotion motion(moments, omega0, q0);
  const PeriodicOracle oracle(I, omega0, q0, Polhode(moments, omega0).period());
  double attitude = 0, omega = 0;
  for (const double t : times) {
    const auto expected = oracle.at(t);
    const RigidBodyState state = motion.at(t);
    attitude = std::max(attitude, Oracle::angle(expected.q, state.q_WB));
    omega = std::max(omega, Oracle::distance(expected.omega, state.omega_B));
  }
  expectResidual(name, attitude, 4e-15);
  expectResidual("  omega_B, of the start's", omega / omega0.norm(), 4e-15);
}

TEST(FreeMotionLongTime, StaysAccurateAboutTheLargestAxis) {
  expectAtLongTimes("about the largest", {2, 3, 4}, {.5, .25, 1}, {1e3, 12345.678, -1e6, 1e9, 1e12, 3.3e14});
}

TEST(FreeMotionLongTime, StaysAccurateAboutTheSmallestAxis) {
  expectAtLongTimes("about the smallest", {0.3, 1.1, 1.2}, {1, -.4, .7},
                    {1e3, 12345.678, -1e6, 1e9, 1e12, 3.3e14});
}

TEST(FreeMotionLongTime, StaysAccurateForATennisRacket) {
  expectAtLongTimes("racket", {0.0133, 0.0014, 0.0147}, {6, 0.001, 0.02}, {100, 4567.8, -1e6, 1e9, 1e12});
}

TEST(FreeMotionLongTime, StaysAccurateOneUlpFromTheSeparatrix) {
  expectAtLongTimes("one ulp off", {1, 2, 2.25}, {.75, .5, 1 + 0x1p-52}, {119, 1e4, -1e6, 1e9, 1e12});
}

/// On the separatrix omega settles on the middle axis as e^(-lambda t). The oracle integrates until lambda t = 60,
/// when the other components are 1e-26. Then the body turns steadily about L at the remaining |omega|.
TEST(FreeMotionLongTime, StaysAccurateOnTheSeparatrix) {
  const Vector3d I(1, 2, 2.25), omega0(.75, .5, 1);
  const Quaterniond q0(0.5, -0.25, 0.75, 1.5);
  const FreeMotion motion(PrincipalMoments(I), omega0, q0);
  const Oracle oracle(I, omega0, q0);
  const Real60 settled_s = 60 / 0.4289845892077917;  // lambda
  double worst = 0;
  for (const double t : {200.0, -200.0, 12345.678, -1e6, 1e9, -1e12}) {
    Oracle::State state = oracle.at(t < 0 ? Real60(-settled_s) : settled_s);
    const auto& w = state.omega;
    const Real60 rest = abs(Real60(t)) - settled_s;
    const Real60 rate = sqrt(Real60(w[0] * w[0] + w[1] * w[1] + w[2] * w[2])), half = rate * rest / 2;
    const Real60 s = (t < 0 ? Real60(-sin(half)) : Real60(sin(half))) / rate;
    state.q = Oracle::product(state.q, {cos(half), s * w[0], s * w[1], s * w[2]});
    worst = std::max(worst, Oracle::angle(state.q, motion.at(t).q_WB));
  }
  expectResidual("separatrix", worst, 4e-15);  // measured 3.2e-16
}

TEST(FreeMotionLongTime, StaysAccurateForANearlySymmetricBody) {
  expectAtLongTimes("nearly symmetric", {1, 1 + 1e-9, 1.75}, {.6, .3, 1}, {1e3, -1e6, 1e9, 1e12});
}

}  // namespace
}  // namespace poinsot::physics
