// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "physics/driven_testing.h"

// The integrated motion is compared with the Taylor integrator of the plain equations (driven_oracle.h), for every
// kind of forcing and random bodies. The bound is the requested tolerance.

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

Forcing gravity(const Vector3d& mgr) {
  Forcing f;
  f.gravity_B = mgr;
  return f;
}

Forcing everything(Draw& draw) {
  Forcing f = gravity(draw.direction());
  f.torque_B = 0.2 * draw.direction();
  f.torque_W = 0.2 * draw.direction();
  f.dragRate_P = Vector3d(draw.between(0, 0.2), draw.between(0, 0.2), draw.between(0, 0.2));
  f.dissipation = draw.between(0, 0.02);
  return f;
}

DrivenCase randomCase(Draw& draw, const Forcing& forcing) {
  DrivenCase c;
  c.I = draw.moments().values();
  c.omega0 = draw.direction() * draw.between(0.3, 3);
  c.q0 = draw.attitude();
  c.forcing = forcing;
  c.span = {-5, 10};
  return c;
}

/// Expects an error within the tolerance, or within 3 times the estimate if rounding limits the run. The error
/// must never exceed 3 times the estimate.
void expectAccurate(const char* name, const DrivenCase& c, double tolerance) {
  const DrivenMotion motion = c.motion(tolerance);
  const DrivenMotionReport& report = motion.report();
  const double error = residualsOf(c, motion).attitude_rad;
  expectResidual(name, error, report.limitedByRounding ? 3 * report.estimatedAttitudeError_rad : tolerance);
  EXPECT_LE(error, 3 * report.estimatedAttitudeError_rad) << name;
  EXPECT_GE(report.tolerance_rad, report.limitedByRounding ? 0 : report.estimatedAttitudeError_rad) << name;
}

void expectAccurateCases(const char* name, std::uint64_t seed, int cases, double tolerance,
                         const std::function<Forcing(Draw&)>& drawForcing) {
  Draw draw(seed);
  for (int i = 0; i < cases; ++i) {
    const Forcing forcing = drawForcing(draw);
    expectAccurate(name, randomCase(draw, forcing), tolerance);
  }
}

TEST(DrivenAccuracy, MeetsTheToleranceForAnAsymmetricHeavyTop) {
  const auto f = [](Draw& draw) { return gravity(draw.direction()); };
  expectAccurateCases("heavy top", 101, 12, 1e-12, f);
  expectAccurateCases("heavy top, 1e-9", 102, 12, 1e-9, f);
}

TEST(DrivenAccuracy, MeetsTheToleranceForTorqueInBodyAxes) {
  expectAccurateCases("body torque", 103, 8, 1e-12, [](Draw& draw) {
    Forcing f;
    f.torque_B = 0.3 * draw.direction();
    return f;
  });
}

TEST(DrivenAccuracy, MeetsTheToleranceForTorqueInSpaceAxes) {
  expectAccurateCases("space torque", 104, 8, 1e-12, [](Draw& draw) {
    Forcing f;
    f.torque_W = 0.3 * draw.direction();
    return f;
  });
}

TEST(DrivenAccuracy, MeetsTheToleranceForUnequalDrag) {
  expectAccurateCases("drag", 105, 6, 1e-12, [](Draw& draw) {
    Forcing f;
    f.dragRate_P = Vector3d(draw.unit(), draw.unit(), draw.unit());
    return f;
  });
}

TEST(DrivenAccuracy, MeetsTheToleranceForEqualDrag) {
  expectAccurateCases("equal drag", 106, 8, 1e-12, [](Draw& draw) {
    Forcing f;
    f.dragRate_P.setConstant(draw.unit());
    return f;
  });
  expectAccurateCases("equal drag and gravity", 107, 6, 1e-12, [](Draw& draw) {
    Forcing f = gravity(draw.direction());
    f.dragRate_P.setConstant(0.3 * draw.unit());
    return f;
  });
}

TEST(DrivenAccuracy, MeetsTheToleranceForEnergyLoss) {
  expectAccurateCases("dissipation", 108, 6, 1e-12, [](Draw& draw) {
    Forcing f;
    f.dissipation = 0.2 * draw.unit();
    return f;
  });
}

TEST(DrivenAccuracy, MeetsTheToleranceForAllForcingsTogether) {
  expectAccurateCases("all", 109, 6, 1e-12, everything);
  expectAccurateCases("all, 1e-9", 110, 6, 1e-9, everything);
}

}  // namespace
}  // namespace poinsot::physics
