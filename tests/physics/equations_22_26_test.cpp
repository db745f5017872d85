// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "physics/free_motion.h"
#include "physics/high_order_difference.h"
#include "physics/polhode.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

// Euler's equations, the lecture's eq (22) to (26), along the closed form.

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

struct Case {
  PrincipalMoments moments;
  FreeMotion motion;
  double t;
};

Case randomCase(Draw& draw) {
  const PrincipalMoments moments = draw.moments();
  return {moments, FreeMotion(moments, draw.direction(), draw.attitude()), draw.between(-50, 50)};
}

// Eq (24) to (26), no torque: I1 omega1' - omega2 omega3 (I2 - I3) = 0 and cyclic.
TEST(Equation24To26, HoldAlongTheMotion) {
  Draw draw(231);
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const Case c = randomCase(draw);
    const Vector3d rate = derivative([&](double t) { return c.motion.at(t).omega_B; }, c.t);
    const Vector3d w = c.motion.at(c.t).omega_B, &I = c.moments.values();
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      worst = std::max(worst, std::abs(I[k] * rate[k] - w[l] * w[m] * (I[l] - I[m])) / I.maxCoeff());
    }
  }
  expectResidual("Euler's equations, rad/s²", worst, 5e-13);  // measured 3.6e-14
}

// Eq (22), (23): dL/dt = 0 in space and -omega × L in the body. R^T L gives L in the body from the attitude alone.
TEST(Equation22And23, AngularMomentumInTheBodyTurnsBackwards) {
  Draw draw(232);
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const Case c = randomCase(draw);
    const double L = c.motion.L_W().norm();
    const auto L_B = [&](double t) { return Vector3d(c.motion.at(t).q_WB.conjugate() * c.motion.L_W()); };
    const Vector3d rate = derivative(L_B, c.t), omega_B = c.motion.at(c.t).omega_B;
    worst = std::max(worst, (rate + omega_B.cross(L_B(c.t))).norm() / L);
  }
  expectResidual("dL/dt in the body + omega × L, relative, 1/s", worst, 5e-13);  // measured 7.6e-14
}

// The attitude turns at omega: dR/dt v = omega × R v in space.
TEST(Equation22And23, AttitudeTurnsAtOmega) {
  Draw draw(233);
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const Case c = randomCase(draw);
    const Vector3d v_B = draw.direction();
    const auto v_W = [&](double t) { return Vector3d(c.motion.at(t).q_WB * v_B); };
    worst = std::max(worst, (derivative(v_W, c.t) - c.motion.at(c.t).omega_W.cross(v_W(c.t))).norm());
  }
  expectResidual("d(R v)/dt - omega × R v, 1/s", worst, 5e-13);  // measured 9.3e-14
}

// Differences of second order converge as h², so that the motion is smooth and the residuals above are not luck.
TEST(Equation24To26, SecondDifferencesConverge) {
  Draw draw(234);
  for (int i = 0; i < 20; ++i) {
    const Case c = randomCase(draw);
    const auto error = [&](double h) {
      const Vector3d w = c.motion.at(c.t).omega_B;
      const Vector3d exact = c.moments.angularMomentum(w).cross(w).cwiseQuotient(c.moments.values());
      return ((c.motion.at(c.t + h).omega_B - c.motion.at(c.t - h).omega_B) / (2 * h) - exact).norm();
    };
    EXPECT_NEAR(std::log2(error(1e-2) / error(5e-3)), 2, 0.01);  // measured: 1.999 to 2.001
  }
}

}  // namespace
}  // namespace poinsot::physics
