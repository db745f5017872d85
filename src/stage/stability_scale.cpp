// SPDX-License-Identifier: Apache-2.0
#include "stage/stability_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/expect.h"
#include "core/magma.h"
#include "physics/stability.h"
#include "stage/plot/plot_ticks.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kWide = 8;       // larger ratios of two times need a logarithmic scale
constexpr double kDarkest = 0.1;  // start of the scale in the table of magma; darker colours look black
constexpr int kMostScaleTicks = 7;

}  // namespace

StabilityScale::StabilityScale(const physics::PrincipalMoments& moments, double L)
    : moments_(moments), L_(L), separatrix_(physics::separatrix(moments).value()) {
  least_s_ = std::min(time_s(Vector3d::Unit(separatrix_.smallest)), time_s(Vector3d::Unit(separatrix_.largest)));
  most_s_ = 0;
  for (const int extreme : {separatrix_.smallest, separatrix_.largest})
    most_s_ = std::max(most_s_, time_s(std::cos(kDegree) * Vector3d::Unit(separatrix_.middle) +
                                       std::sin(kDegree) * Vector3d::Unit(extreme)));
  logarithmic_ = most_s_ > kWide * least_s_;
}

double StabilityScale::time_s(const Vector3d& direction_P) const {
  return physics::flipInterval(moments_, L_ * direction_P);
}

double StabilityScale::energy(const Vector3d& direction_P) const {
  return moments_.kineticEnergy((L_ * direction_P).cwiseQuotient(moments_.values()));
}

double StabilityScale::share(double time_s) const {
  return logarithmic_ ? std::log(time_s / least_s_) / std::log(most_s_ / least_s_)
                      : (time_s - least_s_) / (most_s_ - least_s_);
}

double StabilityScale::timeAt(double share) const {
  return logarithmic_ ? least_s_ * std::pow(most_s_ / least_s_, share) : least_s_ + share * (most_s_ - least_s_);
}

draw::Color StabilityScale::color(double share) {
  const double place = kDarkest + (1 - kDarkest) * std::clamp(share, 0.0, 1.0);
  const auto [r, g, b] = core::magma(static_cast<std::size_t>(std::lround(255 * place)));
  return {draw::linearFromSrgb8(r), draw::linearFromSrgb8(g), draw::linearFromSrgb8(b)};
}

// Finds the direction by bisection in the plane of the axes of smallest and largest moment. In this plane, the
// time grows from the given axis to the separatrix, where it diverges logarithmically.
std::optional<double> StabilityScale::energyOf(int axis, double time_s) const {
  constexpr int kHalvings = 60;
  const bool smallest = axis == separatrix_.smallest;
  const int other = smallest ? separatrix_.largest : separatrix_.smallest;
  const auto direction = [&](double angle_rad) -> Vector3d {
    return std::cos(angle_rad) * Vector3d::Unit(axis) + std::sin(angle_rad) * Vector3d::Unit(other);
  };
  double nearer = 0;
  double farther =
      smallest ? separatrix_.momentumAngle_rad : 0.5 * std::numbers::pi - separatrix_.momentumAngle_rad;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (nearer + farther);
    (this->time_s(direction(middle)) < time_s ? nearer : farther) = middle;
  }
  return nearer > 0 ? std::optional(energy(direction(nearer))) : std::nullopt;
}

std::vector<TimeCap> StabilityScale::caps(double time_s) const {
  constexpr int kScalePoints = 240;
  std::vector<TimeCap> caps;
  for (const int axis : {separatrix_.smallest, separatrix_.largest}) {
    const auto T = energyOf(axis, time_s);
    if (!T) continue;
    for (const physics::MomentumPolhode& curve : physics::momentumPolhodes(moments_, *T, L_, kScalePoints)) {
      TimeCap& cap = caps.emplace_back();
      for (const Vector3d& m_P : curve.m_P) cap.outline_P.push_back(m_P.normalized());
      // The energy is greatest on the axis of smallest moment.
      const double sense = axis == separatrix_.smallest ? 1 : -1, side = cap.outline_P.front()[axis];
      cap.contains = [*this, axis, T = *T, sense, side](const Vector3d& direction_P) {
        return sense * (energy(direction_P) - T) > 0 && direction_P[axis] * side > 0;
      };
    }
  }
  return caps;
}

std::vector<StabilityScale::Tick> StabilityScale::ticks(double perSecond) const {
  const double low = least_s_ * perSecond, high = most_s_ * perSecond;
  std::vector<Tick> all;
  if (!logarithmic_) {
    const Ticks ticks = innerTicks(low, high, kMostScaleTicks);
    for (auto i = ticks.first; i <= ticks.last; ++i)
      all.push_back({ticks.at(i) / perSecond, tickDigits(ticks, i)});
    return all;
  }
  const auto decades = static_cast<int>(std::ceil(std::log10(high / low)));
  for (int power = static_cast<int>(std::floor(std::log10(low))); std::pow(10.0, power) <= high; ++power)
    for (const int digit : {1, 2, 5}) {
      const double x = digit * std::pow(10.0, power);
      if (x < low || x > high || (decades > 2 && digit != 1)) continue;
      all.push_back({x / perSecond, fmt::format("{:.{}f}", x, std::max(0, -power))});
    }
  return all;
}

}  // namespace poinsot::stage
