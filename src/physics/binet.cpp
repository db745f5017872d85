// SPDX-License-Identifier: Apache-2.0
#include "physics/binet.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/error.h"
#include "core/expect.h"
#include "physics/free_motion_constants.h"
#include "physics/polhode.h"
#include "physics/start.h"
#include "physics/transcendental.h"

namespace poinsot::physics {
namespace {

MomentumPolhode steadyOrClosed(const PrincipalMoments& moments, const EnergyStart& start, int count) {
  const Polhode polhode(moments, omegaFromEnergy(moments, start));
  MomentumPolhode curve{start.kineticEnergy, polhode.regime(), {}};
  for (const PolhodeSample& sample : polhode.samples(count))
    curve.m_P.push_back(moments.angularMomentum(sample.omega_P));
  return curve;
}

double energyOfSpin(double L, double I) { return L * (L / I) / 2; }

/// Returns the kinetic energy of the momentum m with |m| = L in the plane of the axes of smallest and largest
/// moment.
/// @param angle_rad  angle of m from the axis of smallest moment
double energyAt(const PrincipalMoments& moments, const std::array<int, 3>& axis, double L, double angle_rad) {
  const SineCosine a = sineCosine(angle_rad);
  return a.cosine * a.cosine * energyOfSpin(L, moments[axis[0]]) +
         a.sine * a.sine * energyOfSpin(L, moments[axis[2]]);
}

/// Returns the angle psi of the separatrix (struct Separatrix). For a symmetric body, the angle is 0 or pi/2.
double separatrixAngle(double I1, double I2, double I3) {
  return arcTangent(std::sqrt((I3 / I1) * ((I2 - I1) / (I3 - I2))));
}

}  // namespace

BinetConstruction::BinetConstruction(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P) {
  const FreeMotionConstants k = freeMotionConstants(moments, omega_P);
  if (k.L == DoubleDouble(0))
    throw core::physicsError("the body is at rest: Binet's construction needs an angular velocity other than 0");
  const int exponent = k.start.momentExponent + k.start.rateExponent;
  sphereRadius_ = std::ldexp(toDouble(k.L), exponent);
  for (std::size_t i = 0; i < 3; ++i)
    semiAxes_P_[k.start.axis[i]] = std::ldexp(toDouble(sqrt(k.twoT * k.start.I[i])), exponent);
}

std::optional<Separatrix> separatrix(const PrincipalMoments& moments) {
  const auto [smallest, middle, largest] = moments.ascendingAxes();
  const double I1 = moments[smallest], I2 = moments[middle], I3 = moments[largest];
  if (I1 == I2 || I2 == I3) return std::nullopt;
  Separatrix s{smallest, middle, largest, separatrixAngle(I1, I2, I3), 0};
  s.velocityAngle_rad = arcTangent(std::sqrt((I1 / I3) * ((I2 - I1) / (I3 - I2))));
  return s;
}

std::vector<Eigen::Vector3d> Separatrix::momentumCircle(double L, int count, bool mirrored) const {
  POINSOT_EXPECT(count >= 3);
  if (!(L >= 0 && std::isfinite(L)))
    throw core::physicsError(
        fmt::format("the magnitude of the angular momentum must be finite and not negative, got {} "
                    "kg·m²/s",
                    L));
  const SineCosine psi = sineCosine(momentumAngle_rad);
  std::vector<Eigen::Vector3d> circle;
  for (int j = 0; j < count; ++j) {
    const SineCosine a = sineCosine(kTwoPi * (static_cast<double>(j) / count));
    Eigen::Vector3d m_P;
    m_P[middle] = L * a.cosine;
    m_P[smallest] = L * a.sine * psi.cosine;
    m_P[largest] = (mirrored ? -L : L) * a.sine * psi.sine;
    circle.push_back(m_P);
  }
  return circle;
}

std::vector<MomentumPolhode> momentumPolhodes(const PrincipalMoments& moments, double T, double L, int count) {
  const MomentumPolhode first = steadyOrClosed(moments, {T, L, 0, false}, count);
  const auto parting = separatrix(moments);
  // An energy of exactly L²/(2 I2) belongs to the separatrix. Its two circles are computed directly, because the
  // rounded start may be next to the separatrix.
  if (parting && T == energyOfSpin(L, moments[parting->middle]))
    return {{T, PolhodeRegime::kSeparatrix, parting->momentumCircle(L, count, false)},
            {T, PolhodeRegime::kSeparatrix, parting->momentumCircle(L, count, true)}};
  return {first, steadyOrClosed(moments, {T, L, 0, true}, count)};
}

std::vector<double> evenEnergies(const PrincipalMoments& moments, double L, int perSide) {
  POINSOT_EXPECT(L > 0 && std::isfinite(L) && perSide >= 1);
  const auto axis = moments.ascendingAxes();
  const double I1 = moments[axis[0]], I2 = moments[axis[1]], I3 = moments[axis[2]];
  if (I1 == I3) return {};
  const double psi = separatrixAngle(I1, I2, I3);
  std::vector<double> energies;
  const auto addBetween = [&](double from_rad, double to_rad) {
    for (int j = 1; j <= perSide && from_rad > to_rad; ++j)
      energies.push_back(energyAt(moments, axis, L, from_rad + (to_rad - from_rad) * j / (perSide + 1)));
  };
  addBetween(kHalfPi.hi, psi);
  addBetween(psi, 0);
  return energies;
}

std::vector<Eigen::Vector3d> onEnergyEllipsoid(const MomentumPolhode& curve, const PrincipalMoments& moments,
                                               double T) {
  POINSOT_EXPECT(T > 0 && std::isfinite(T) && curve.kineticEnergy > 0);
  const double factor = std::sqrt(T / curve.kineticEnergy);
  std::vector<Eigen::Vector3d> omega_P;
  for (const Eigen::Vector3d& m_P : curve.m_P) omega_P.push_back(factor * m_P.cwiseQuotient(moments.values()));
  return omega_P;
}

}  // namespace poinsot::physics
