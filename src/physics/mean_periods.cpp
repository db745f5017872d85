// SPDX-License-Identifier: Apache-2.0
#include "physics/mean_periods.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "physics/herpolhode.h"
#include "physics/polhode.h"
#include "physics/require_finite.h"
#include "physics/start.h"

namespace poinsot::physics {
namespace {

/// Moments in ascending order.
Eigen::Vector3d ascending(const PrincipalMoments& moments) {
  const auto axis = moments.ascendingAxes();
  return {moments[axis[0]], moments[axis[1]], moments[axis[2]]};
}

bool hasLongAxis(const PrincipalMoments& moments) {
  const Eigen::Vector3d I = ascending(moments);
  return I[0] < I[1] && I[1] < I[2];
}

/// Part of the way from the steady spin (0) to the separatrix (1), in L²/2T, at |L| = 1.
EnergyStart startAt(const PrincipalMoments& moments, AxisMode mode, double part) {
  const Eigen::Vector3d I = ascending(moments);
  const double steady = mode == AxisMode::kLong ? I[0] : I[2];
  return {0.5 / (steady + part * (I[1] - steady)), 1, 0, false};
}

/// Returns the periods at |L| = 1; nullopt where the start is rounded to a steady spin or to the separatrix.
std::optional<MeanPeriods> periodsAt(const PrincipalMoments& moments, AxisMode mode, double part) {
  return meanPeriods(moments, omegaFromEnergy(moments, startAt(moments, mode, part)));
}

double ratioOf(const MeanPeriods& periods) { return periods.psi_s / periods.phi_s; }

// Within these parts, the periods are exact to rounding. Nearer to the steady spin, T - L²/2I loses its digits.
constexpr double kNearSteady = 1e-12, kNearSeparatrix = 1 - 1e-12;

bool hasRatio(const PrincipalMoments& moments, AxisMode mode, double ratio) {
  const auto least = periodsAt(moments, mode, kNearSteady), most = periodsAt(moments, mode, kNearSeparatrix);
  return least && most && ratioOf(*least) <= ratio && ratio <= ratioOf(*most);
}

double partWithRatio(const PrincipalMoments& moments, AxisMode mode, double ratio) {
  double below = kNearSteady, above = kNearSeparatrix;
  for (;;) {
    const double middle = below + (above - below) / 2;
    if (middle == below || middle == above) return middle;
    const auto periods = periodsAt(moments, mode, middle);
    (periods && ratioOf(*periods) < ratio ? below : above) = middle;
  }
}

std::string leastText(const PrincipalMoments& moments, AxisMode mode) {
  const auto least = periodsAt(moments, mode, kNearSteady);
  return least ? fmt::format("{:.6g}", ratioOf(*least)) : "none";
}

AxisMode modeOf(const PrincipalMoments& moments, const PeriodStart& start) {
  const double ratio = start.psi_s / start.phi_s;
  const bool isShort = hasRatio(moments, AxisMode::kShort, ratio),
             isLong = hasRatio(moments, AxisMode::kLong, ratio);
  const bool hasAsked = !start.mode || (*start.mode == AxisMode::kShort ? isShort : isLong);
  if (!hasAsked || (!isShort && !isLong))
    throw core::physicsError(
        fmt::format("no rotation of this body has P_psi/P_phi = {:.6g}{}; the ratio is at least {} if L circles "
                    "the short axis (SAM), "
                    "and at least {} if it circles the long axis (LAM)",
                    ratio, start.mode ? " in this mode" : "", leastText(moments, AxisMode::kShort),
                    leastText(moments, AxisMode::kLong)));
  if (!start.mode && isShort && isLong)
    throw core::physicsError("two rotations of this body have these periods; choose one by the mode SAM or LAM");
  return start.mode.value_or(isShort ? AxisMode::kShort : AxisMode::kLong);
}

void requirePeriod(double period_s, const char* name) {
  requireFinite(period_s, name, " s");
  if (!(period_s > 0)) throw core::physicsError(fmt::format("{} must be positive, got {} s", name, period_s));
}

}  // namespace

// In a period of the polhode, omega turns about L by twice the herpolhode's angle. If L circles the long axis, so
// does omega, and the long axis turns by the same angle. If L circles the short axis, the long axis goes round the
// short axis once against this turn.
std::optional<MeanPeriods> meanPeriods(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P) {
  const Herpolhode curve(moments, omega0_P);
  const bool isShort = curve.regime() == PolhodeRegime::kAboutLargest;
  if (!hasLongAxis(moments) || (!isShort && curve.regime() != PolhodeRegime::kAboutSmallest)) return std::nullopt;
  const double psi_s = 2 * curve.radialPeriod();
  const double turned_rad = 2 * curve.anglePerRadialPeriod() - (isShort ? 2 * std::numbers::pi : 0);
  return MeanPeriods{psi_s * (2 * std::numbers::pi / turned_rad), psi_s, isShort ? AxisMode::kShort : AxisMode::kLong};
}

Eigen::Vector3d omegaFromPeriods(const PrincipalAxes& axes, const PeriodStart& start) {
  requirePeriod(start.phi_s, "P_phi");
  requirePeriod(start.psi_s, "P_psi");
  const PrincipalMoments& moments = axes.moments();
  if (!hasLongAxis(moments))
    throw core::physicsError(
        "P_phi and P_psi need three different moments of inertia: otherwise the body has no long axis");
  const AxisMode mode = modeOf(moments, start);
  const double part = partWithRatio(moments, mode, start.psi_s / start.phi_s);
  const double L = periodsAt(moments, mode, part)->phi_s / start.phi_s;
  EnergyStart energy = startAt(moments, mode, part);
  energy.kineticEnergy *= L * L;
  energy.angularMomentum = L;
  energy.phase = start.phase;
  energy.negative = start.negative;
  return omegaFromEnergy(axes, energy);
}

}  // namespace poinsot::physics
