// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>

#include "physics/free_motion.h"
#include "physics/polhode.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"
#include "physics/taylor_oracle.h"

// The closed form is compared with the Taylor integrator in every regime. Bounds: attitude 4e-15 rad, omega 4e-15
// of the largest |omega| of the motion.

namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kBound = 4e-15;

struct Start {
  Vector3d I, omega0;
  Quaterniond q0;
};

struct Residuals {
  double attitude_rad = 0, omega = 0;
};

/// Returns the largest differences from the oracle at random times up to `longest` / |omega0|.
template <typename Real>
Residuals residualsOf(const Start& start, Draw& draw, int times, double longest) {
  const TaylorOracle<Real> oracle(start.I, start.omega0, start.q0);
  const FreeMotion motion(PrincipalMoments(start.I), start.omega0, start.q0);
  Residuals worst;
  double largestOmega = start.omega0.norm();
  for (int i = 0; i < times; ++i) {
    const double t = draw.between(-longest, longest) / start.omega0.norm();
    const auto expected = oracle.at(Real(t));
    const RigidBodyState state = motion.at(t);
    worst.attitude_rad = std::max(worst.attitude_rad, TaylorOracle<Real>::angle(expected.q, state.q_WB));
    worst.omega = std::max(worst.omega, TaylorOracle<Real>::distance(expected.omega, state.omega_B));
    largestOmega = std::max(largestOmega, state.omega_B.norm());
  }
  worst.omega /= largestOmega;
  return worst;
}

template <typename Real>
void compare(const char* name, std::uint64_t seed, int bodies, double longest,
             const std::function<Start(Draw&)>& drawStart) {
  Draw draw(seed);
  Residuals worst;
  for (int i = 0; i < bodies; ++i) {
    const Residuals r = residualsOf<Real>(drawStart(draw), draw, 2, longest);
    worst = {std::max(worst.attitude_rad, r.attitude_rad), std::max(worst.omega, r.omega)};
  }
  expectResidual(name, worst.attitude_rad, kBound);
  expectResidual("  omega_B, of the largest", worst.omega, kBound);
}

Start randomStart(Draw& draw) {
  return {draw.moments().values(), draw.direction() * draw.between(0.3, 3), draw.attitude()};
}

Vector3d permuted(const Vector3d& v, int shift) { return {v[shift % 3], v[(shift + 1) % 3], v[(shift + 2) % 3]}; }

int axisOf(Draw& draw) { return static_cast<int>(draw.between(0, 3)); }

// Long double suffices where nothing amplifies rounding: its error here is below 1e-17.
TEST(FreeMotionOracle, AgreesForRandomBodies) { compare<long double>("random", 1, 400, 25, randomStart); }

TEST(FreeMotionOracle, AgreesForNearlySymmetricBodies) {
  compare<long double>("nearly symmetric", 2, 200, 25, [](Draw& draw) {
    const double ratio = draw.between(0.55, 1.9), gap = draw.decade(-16, -1);
    const Vector3d I(1, 1 + gap, ratio);
    return Start{permuted(I, axisOf(draw)), draw.direction(), draw.attitude()};
  });
}

TEST(FreeMotionOracle, AgreesForSymmetricBodies) {
  compare<long double>("symmetric", 3, 100, 25, [](Draw& draw) {
    return Start{permuted({1, 1, draw.between(0.2, 2)}, axisOf(draw)), draw.direction(), draw.attitude()};
  });
}

TEST(FreeMotionOracle, AgreesForNearlySphericalBodies) {
  compare<long double>("near spheres", 4, 100, 25, [](Draw& draw) {
    const double gap = draw.decade(-15, -2);
    const Vector3d I(1 + gap * draw.unit(), 1 + gap * draw.unit(), 1 + gap * draw.unit());
    return Start{I, draw.direction(), draw.attitude()};
  });
}

TEST(FreeMotionOracle, AgreesForRods) {
  compare<long double>("rods", 5, 100, 10, [](Draw& draw) {
    const double thin = draw.decade(-5, -1);
    const Vector3d I(thin, 1, 1 + thin * draw.between(-1, 1));
    // Momenta about all axes are similar; otherwise only the short axis would turn.
    const Vector3d m = draw.direction() * 0.3;
    return Start{permuted(I, 0), m.cwiseQuotient(Vector3d(std::sqrt(thin), 1, 1)), draw.attitude()};
  });
}

TEST(FreeMotionOracle, AgreesForNearlySteadySpins) {
  compare<Real60>("nearly steady", 6, 10, 15, [](Draw& draw) {
    const Vector3d spin = Vector3d::Unit(axisOf(draw)) * draw.sign();
    return Start{draw.moments().values(), spin + draw.decade(-14, -2) * draw.direction(), draw.attitude()};
  });
}

// I3 (I3 - I2) w3^2 = I1 (I2 - I1) w1^2 holds exactly for these doubles if `ulps` is 0.
Start nearSeparatrix(Draw& draw, int ulps) {
  Vector3d omega(0.75 * draw.sign(), draw.between(-1, 1), draw.sign());
  omega[2] *= 1 + ulps * 0x1p-52;
  const int shift = axisOf(draw);
  return {permuted({1, 2, 2.25}, shift) * 8, permuted(omega, shift), draw.attitude()};
}

TEST(FreeMotionOracle, AgreesOnTheSeparatrix) {
  compare<Real60>("separatrix", 7, 10, 30, [](Draw& draw) { return nearSeparatrix(draw, 0); });
}

TEST(FreeMotionOracle, AgreesOneUlpFromTheSeparatrix) {
  compare<Real60>("one ulp outside", 8, 4, 60, [](Draw& draw) { return nearSeparatrix(draw, 1); });
  compare<Real60>("one ulp inside", 9, 4, 60, [](Draw& draw) { return nearSeparatrix(draw, -1); });
}

TEST(FreeMotionOracle, AgreesNearTheSeparatrix) {
  compare<Real60>("spin about the middle axis, disturbed", 13, 10, 40, [](Draw& draw) {
    const Vector3d disturbance = draw.decade(-8, -1) * draw.direction();
    const int shift = axisOf(draw);
    const double middle = draw.between(1.01, 1.9);
    return Start{permuted({1, middle, draw.between(middle, 1 + middle)}, shift),
                 permuted(Vector3d(0, draw.sign(), 0) + disturbance, shift), draw.attitude()};
  });
}

TEST(FreeMotionOracle, AgreesForSteadySpins) {
  compare<long double>("steady", 10, 60, 25, [](Draw& draw) {
    const Vector3d spin = Vector3d::Unit(axisOf(draw)) * draw.between(-2, 2);
    return Start{draw.moments().values(), spin, draw.attitude()};
  });
  compare<long double>("sphere", 11, 60, 25, [](Draw& draw) {
    return Start{Vector3d::Constant(0.7), draw.direction(), draw.attitude()};
  });
  compare<long double>("equatorial spin", 12, 60, 25, [](Draw& draw) {
    return Start{{1, 1, 0.4}, {draw.between(-1, 1), draw.between(-1, 1), 0}, draw.attitude()};
  });
}

}  // namespace
}  // namespace poinsot::physics
