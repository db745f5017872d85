// SPDX-License-Identifier: Apache-2.0
#include "physics/polhode.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/expect.h"
#include "physics/elliptic.h"
#include "physics/free_motion_constants.h"
#include "physics/transcendental.h"

namespace poinsot::physics {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

/// Amplitude a of the elliptic functions, stored as sn = sin a and cn = cos a.
struct Amplitude {
  double sn = 0;
  double cn = 1;
};

Amplitude rotatedBy(const Amplitude& a, const SineCosine& turn) {
  return {a.sn * turn.cosine + a.cn * turn.sine, a.cn * turn.cosine - a.sn * turn.sine};
}

/// Returns the amplitude a as an angle in (-pi/2, 3 pi/2].
double angleOf(const Amplitude& a) { return arcTangent(a.sn / a.cn) + (a.cn < 0 ? kPi.hi : 0); }

Eigen::Vector3d omegaAt(const FreeMotionConstants& k, const Amplitude& a) {
  const double dn = std::sqrt(a.cn * a.cn + toDouble(k.mc) * a.sn * a.sn);
  std::array<double, 3> m{};
  m[k.a] = k.sigmaA * toDouble(k.A_a) * a.cn;
  m[1] = k.sigma * k.sigmaA * toDouble(k.A_2) * a.sn;
  m[k.c] = k.sigma * toDouble(k.A_c) * dn;
  for (std::size_t i = 0; i < 3; ++i) m[i] = std::ldexp(m[i] / k.start.I[i], k.start.rateExponent);
  return k.start.toP(m);
}

/// Returns the elliptic integral of the first kind, measured from the nearest multiple N of pi. The complete phase
/// is u = 2 K N +- this integral.
double firstKind(const FreeMotionConstants& k, const Amplitude& a) {
  const double cn2 = a.cn * a.cn;
  return a.sn * carlsonRF(cn2, cn2 + toDouble(k.mc) * a.sn * a.sn, 1.0);
}

double seconds(const FreeMotionConstants& k, double du) {
  return std::ldexp(du / toDouble(k.lambda), -k.start.rateExponent);
}

std::vector<PolhodeSample> closedCurve(const FreeMotionConstants& k, int count) {
  const Amplitude start{toDouble(k.sn0), toDouble(k.cn0)};
  const double a0 = angleOf(start);
  std::vector<PolhodeSample> samples;
  double u0 = 0;
  for (int j = 0; j < count; ++j) {
    const DoubleDouble turn = kTwoPi * (static_cast<double>(j) / count);
    const Amplitude a = rotatedBy(start, sineCosine(turn));
    const double halfTurns = std::round((a0 + turn.hi) / kPi.hi);
    const bool odd = std::fmod(halfTurns, 2) != 0;
    const double u = 2 * toDouble(k.K) * halfTurns + (odd ? -1 : 1) * firstKind(k, a);
    if (j == 0) u0 = u;
    samples.push_back({seconds(k, u - u0), omegaAt(k, a)});
  }
  return samples;
}

std::vector<PolhodeSample> halfCurve(const FreeMotionConstants& k, int count) {
  std::vector<PolhodeSample> samples{{-kNoEnd, omegaAt(k, {-1, 0})}};
  for (int j = 1; j + 1 < count; ++j) {
    const SineCosine angle = sineCosine(kPi * (static_cast<double>(j) / (count - 1)) - kHalfPi);
    const Amplitude a{angle.sine, angle.cosine};
    samples.push_back({seconds(k, firstKind(k, a) - toDouble(k.u0)), omegaAt(k, a)});
  }
  samples.push_back({kNoEnd, omegaAt(k, {1, 0})});
  return samples;
}

}  // namespace

Polhode::Polhode(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P)
    : constants_(std::make_shared<const FreeMotionConstants>(freeMotionConstants(moments, omega0_P))) {}

PolhodeRegime Polhode::regime() const { return constants_->regime; }

double Polhode::period() const {
  const FreeMotionConstants& k = *constants_;
  if (k.regime == PolhodeRegime::kSteady) return 0;
  if (k.regime == PolhodeRegime::kSeparatrix) return kNoEnd;
  return std::ldexp(toDouble(k.K * 4.0 / k.lambda), -k.start.rateExponent);
}

std::vector<PolhodeSample> Polhode::samples(int count) const {
  POINSOT_EXPECT(count >= 4);
  const FreeMotionConstants& k = *constants_;
  if (k.periodic()) return closedCurve(k, count);
  if (k.regime == PolhodeRegime::kSeparatrix) return halfCurve(k, count);
  std::array<double, 3> omega{};
  for (std::size_t i = 0; i < 3; ++i) omega[i] = std::ldexp(k.start.omega[i], k.start.rateExponent);
  return {{0, k.start.toP(omega)}};
}

}  // namespace poinsot::physics
