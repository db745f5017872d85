// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "draw/color.h"
#include "physics/binet.h"
#include "physics/principal_moments.h"

namespace poinsot::stage {

/// A part of the sphere of directions of L: round one end of an extreme axis, within a polhode. Unit, in principal
/// axes.
struct TimeCap {
  std::vector<Eigen::Vector3d> outline_P;  ///< the polhode, closed
  std::function<bool(const Eigen::Vector3d&)> contains;
};

/// The times between flips of a body, over all directions of its L, and the colours that mean them. Times are even
/// on the scale, or where they differ much, their logarithms.
class StabilityScale {
 public:
  /// @param L  |L|, kg·m²/s. @pre the moments differ, L > 0
  StabilityScale(const physics::PrincipalMoments& moments, double L);

  double least_s() const { return least_s_; }
  /// Beyond, all have one colour: within a degree of the middle axis, and along the separatrix.
  double most_s() const { return most_s_; }
  bool isLogarithmic() const { return logarithmic_; }

  /// 0 at the least time, 1 at the most; more beyond that.
  double share(double time_s) const;
  double timeAt(double share) const;
  static draw::Color color(double share);

  /// One of the places on the scale that have a label.
  struct Tick {
    double time_s;
    std::string digits;  ///< in seconds times `perSecond`
  };
  /// Written numbers are `perSecond` times seconds.
  std::vector<Tick> ticks(double perSecond) const;

  /// The parts of the sphere of directions where the time is shorter: round the ends of the axis of smallest
  /// moment, of largest, or both.
  std::vector<TimeCap> caps(double time_s) const;

  const physics::Separatrix& separatrix() const { return separatrix_; }
  /// For a direction of L, unit, in principal axes.
  double time_s(const Eigen::Vector3d& direction_P) const;
  double energy(const Eigen::Vector3d& direction_P) const;

 private:
  /// The energy of the polhodes round an extreme axis that take this time; none where all of them take longer.
  std::optional<double> energyOf(int axis, double time_s) const;

  physics::PrincipalMoments moments_;
  double L_;
  physics::Separatrix separatrix_;
  double least_s_, most_s_;
  bool logarithmic_;
};

}  // namespace poinsot::stage
