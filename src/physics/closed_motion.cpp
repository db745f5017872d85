// SPDX-License-Identifier: Apache-2.0
#include "physics/closed_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/error.h"
#include "core/expect.h"
#include "physics/free_motion.h"
#include "physics/free_motion_constants.h"
#include "physics/herpolhode.h"
#include "physics/transcendental.h"

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

constexpr double kTolerance = 0.25;     // accepted deviation of the period, relative to the wanted time
constexpr int kMostMultiples = 64;      // multiples of the polhode's period to try; more change nothing visible
constexpr double kUndrawable = 1e-3;    // largest invisible angle, rad: half a pixel on an axis of 500 pixels
constexpr double kFarthestRatio = 1e9;  // limits of the ratio r: 1e9 (nearly steady), 1e-9 (near the separatrix)
constexpr double kLargestCount = 1e9;   // limit of the number of periods in the wanted time

double length(const Vector3d& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/// Returns the angle between two vectors, from the difference and the sum of their unit vectors. This formula is
/// accurate for small and large angles.
double angleBetween(const Vector3d& v, const Vector3d& w) {
  const Vector3d a = v / length(v), b = w / length(w);
  return 2 * arcTangent(length(a - b) / length(a + b));
}

/// Family of the polhodes with the same |L| about the same axis c (axes a, 2, c as in FreeMotionConstants). A
/// polhode is identified by the ratio r = m_c/m_2 at m_a = 0. The ratio is infinite for the steady spin about c,
/// and 0 for the separatrix. Unlike the invariants, r has full relative accuracy at both ends.
class PolhodeFamily {
 public:
  PolhodeFamily(const PrincipalMoments& moments, const FreeMotionConstants& k) : moments_(moments), k_(k) {}

  double ratioAtStart() const { return toDouble(k_.A_c * sqrt(k_.mc) / k_.A_2); }

  Vector3d omegaAt(double r) const {
    const double L = toDouble(k_.L), size = std::sqrt(1 + r * r);
    return omega_P(0, L / size, L * (r / size));
  }

  Herpolhode herpolhode(double r) const { return {moments_, omegaAt(r)}; }
  double angle(double r) const { return herpolhode(r).anglePerRadialPeriod(); }

  int rateExponent() const { return k_.start.rateExponent; }

  Vector3d steadySpin() const { return omega_P(0, 0, toDouble(k_.L)); }

  /// Returns omega in rad/s from the components of L along the axes a, 2 and c. m_c gets the sign of the start.
  Vector3d omega_P(double m_a, double m_2, double m_c) const {
    std::array<double, 3> sorted{};
    sorted[k_.a] = m_a / k_.start.I[k_.a];
    sorted[1] = m_2 / k_.start.I[1];
    sorted[k_.c] = k_.sigma * m_c / k_.start.I[k_.c];
    const Vector3d scaled = k_.start.toP(sorted);
    return scaled.unaryExpr([&](double w) { return std::ldexp(w, k_.start.rateExponent); });
  }

 private:
  const PrincipalMoments& moments_;
  const FreeMotionConstants& k_;
};

/// Returns the ratio r between `low` and `high` at which the angle of the polhode is `target`, exact to the last
/// bit.
double root(const PolhodeFamily& family, double target, double low, double high) {
  const bool lowIsAbove = family.angle(low) > target;
  for (;;) {
    const double middle = low * std::sqrt(high / low);
    if (!(middle > std::min(low, high) && middle < std::max(low, high))) return middle;
    ((family.angle(middle) > target) == lowIsAbove ? low : high) = middle;
  }
}

/// Searches for the ratio r at which the angle of the polhode is `target`, in growing steps from `from`. Returns
/// nullopt if r leaves the limits of kFarthestRatio.
/// @param larger  true to search above `from`, false to search below
std::optional<double> ratioBeyond(const PolhodeFamily& family, double from, double target, bool larger) {
  const bool above = family.angle(from) > target;
  double step = 1.02;
  for (double r = from; r < kFarthestRatio && r > 1 / kFarthestRatio;) {
    const double next = larger ? r * step : r / step;
    if ((family.angle(next) > target) != above) return root(family, target, r, next);
    r = next;
    step = std::min(1 + 1.1 * (step - 1), 2.0);
  }
  return std::nullopt;
}

/// Search for the point of a polhode that is nearest to omega0_P. Takes the best of 256 points on the polhode and
/// refines it by golden-section search.
class NearestPoint {
 public:
  NearestPoint(const PolhodeFamily& family, const PrincipalMoments& moments, double r, const Vector3d& omega0_P)
      : family_(family), k_(freeMotionConstants(moments, family.omegaAt(r))), omega0_P_(omega0_P) {}

  Vector3d operator()() const {
    constexpr int kRing = 256;
    constexpr double kSpacing = 2 * kPi.hi / kRing;
    int best = 0;
    for (int i = 1; i < kRing; ++i)
      if (distance(i * kSpacing) < distance(best * kSpacing)) best = i;
    return pointAt(refined((best - 1) * kSpacing, (best + 1) * kSpacing));
  }

 private:
  double distance(double a) const { return length(pointAt(a) - omega0_P_); }

  Vector3d pointAt(double a) const {
    const SineCosine f = sineCosine(a);
    const double mc = toDouble(k_.mc), dn = std::sqrt(f.cosine * f.cosine + mc * f.sine * f.sine);
    return family_.omega_P(scaled(k_.A_a) * f.cosine, scaled(k_.A_2) * f.sine, scaled(k_.A_c) * dn);
  }

  /// Converts an amplitude of this polhode to the units of the family, which may differ by a power of two.
  double scaled(const DoubleDouble& amplitude) const {
    return std::ldexp(toDouble(amplitude), k_.start.rateExponent - family_.rateExponent());
  }

  double refined(double low, double high) const {
    constexpr double kGolden = 0.6180339887498949;
    double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
    double atLeft = distance(left), atRight = distance(right);
    for (int i = 0; i < 60; ++i) {
      if (atLeft < atRight) {
        high = right;
        right = left;
        atRight = atLeft;
        left = high - kGolden * (high - low);
        atLeft = distance(left);
      } else {
        low = left;
        left = right;
        atLeft = atRight;
        right = low + kGolden * (high - low);
        atRight = distance(right);
      }
    }
    return 0.5 * (low + high);
  }

  const PolhodeFamily& family_;
  FreeMotionConstants k_;
  Vector3d omega0_P_;
};

double attitudeMismatch(const PrincipalMoments& moments, const ClosedStart& start) {
  const FreeMotion motion(moments, start.omega0_P, Quaternion::Identity());
  const Quaternion q = motion.at(start.period_s).q_WB;
  const double sine = std::sqrt(q.x() * q.x() + q.y() * q.y() + q.z() * q.z());
  return 2 * arcTangent(sine / std::abs(q.w()));
}

double excess(double time_s, double wanted_s) { return std::max(time_s / wanted_s, wanted_s / time_s); }

class ClosedStartSearch {
 public:
  ClosedStartSearch(const PrincipalMoments& moments, const Vector3d& omega0_P, double wanted_s)
      : moments_(moments),
        omega0_P_(omega0_P),
        wanted_s_(wanted_s),
        k_(freeMotionConstants(moments, omega0_P)),
        family_(moments, k_) {}

  ClosedStart run() {
    if (k_.regime == PolhodeRegime::kSteady) return steady(omega0_P_);
    if (k_.regime == PolhodeRegime::kSeparatrix)
      throw core::physicsError(
          "a motion on the separatrix (L² = 2 T I of the middle moment) approaches the middle axis "
          "for ever and never repeats; change the start a little");
    collect();
    POINSOT_EXPECT(!found_.empty());  // never empty: near the separatrix, the angle grows without bound
    return *std::ranges::min_element(found_, [&](const auto& a, const auto& b) { return better(a, b); });
  }

 private:
  ClosedStart finished(ClosedStart start) const {
    const double size = length(omega0_P_);
    start.change = length(start.omega0_P - omega0_P_);
    start.turned_rad = size > 0 ? angleBetween(start.omega0_P, omega0_P_) : 0;
    start.mismatch_rad = attitudeMismatch(moments_, start);
    return start;
  }

  double multiple(double period_s) const {
    const double count = std::round(wanted_s_ / period_s);
    if (count > kLargestCount)
      throw core::physicsError("the motion turns more than 1e9 times in the time of the loop");
    return std::max(count, 1.0);
  }

  ClosedStart steady(const Vector3d& spin_P) const {
    const double rate = length(spin_P);
    if (rate == 0) return finished({spin_P, wanted_s_});
    const double period_s = 2 * kPi.hi / rate, turns = multiple(period_s);
    return finished({spin_P, turns * period_s, 0, static_cast<int>(turns)});
  }

  void collect() {
    const double r0 = family_.ratioAtStart();
    const Herpolhode now(moments_, omega0_P_);
    if (r0 * kUndrawable > 1) found_.push_back(steady(family_.steadySpin()));
    const double middle = multiple(2 * now.radialPeriod());
    const double spread = std::min(std::floor(kTolerance * middle), kMostMultiples / 2.0);
    for (double m = middle - spread; m <= middle + spread; ++m) {
      const double turns = std::floor(m * (now.anglePerRadialPeriod() / kPi.hi));
      for (const double n : {turns, turns + 1})
        for (const bool larger : {false, true}) tryTarget(r0, m, n, larger);
    }
  }

  void tryTarget(double r0, double m, double n, bool larger) {
    if (n < 1) return;
    const auto r = ratioBeyond(family_, r0, kPi.hi * n / m, larger);
    if (!r) return;
    const Vector3d omega_P = NearestPoint(family_, moments_, *r, omega0_P_)();
    const double period_s = 2 * m * Herpolhode(moments_, omega_P).radialPeriod();
    found_.push_back(finished({omega_P, period_s, static_cast<int>(m), static_cast<int>(n)}));
  }

  bool better(const ClosedStart& a, const ClosedStart& b) const {
    const double ofA = excess(a.period_s, wanted_s_), ofB = excess(b.period_s, wanted_s_);
    const bool fitsA = ofA <= 1 + kTolerance, fitsB = ofB <= 1 + kTolerance;
    if (fitsA != fitsB) return fitsA;
    return fitsA ? a.change < b.change : ofA < ofB;
  }

  const PrincipalMoments& moments_;
  Vector3d omega0_P_;
  double wanted_s_;
  FreeMotionConstants k_;
  PolhodeFamily family_;
  std::vector<ClosedStart> found_;
};

}  // namespace

ClosedStart nearestClosedStart(const PrincipalMoments& moments, const Vector3d& omega0_P, double wanted_s) {
  POINSOT_EXPECT(wanted_s > 0 && std::isfinite(wanted_s));
  return ClosedStartSearch(moments, omega0_P, wanted_s).run();
}

}  // namespace poinsot::physics
