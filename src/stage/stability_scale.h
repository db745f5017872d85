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

/// Part of the sphere of directions of L: the region inside a polhode, around one end of an extreme axis.
/// Directions are unit vectors in principal axes.
struct TimeCap {
  std::vector<Eigen::Vector3d> outline_P;
  std::function<bool(const Eigen::Vector3d&)> contains;
};

/// Scale of the times between flips of a body over all directions of its L, with their colours. The scale is
/// linear, or logarithmic if the times differ much.
class StabilityScale {
 public:
  /// @param L  |L|, kg·m²/s. @pre the moments differ, L > 0
  StabilityScale(const physics::PrincipalMoments& moments, double L);

  double least_s() const { return least_s_; }
  /// Returns the longest time with a colour of its own. Longer times occur within a degree of the middle axis and
  /// along the separatrix, and share one colour.
  double most_s() const { return most_s_; }
  bool isLogarithmic() const { return logarithmic_; }

  /// Returns the place of a time on the scale: 0 at the least time, 1 at the most, above 1 beyond.
  double share(double time_s) const;
  double timeAt(double share) const;
  static draw::Color color(double share);

  struct Tick {
    double time_s;
    std::string digits;  ///< time in the written unit
  };
  /// Returns the labelled places. @param perSecond  factor from seconds to the written unit
  std::vector<Tick> ticks(double perSecond) const;

  /// Returns the parts of the sphere where the time is shorter: around the ends of the axis of smallest moment, of
  /// the axis of largest moment, or of both.
  std::vector<TimeCap> caps(double time_s) const;

  const physics::Separatrix& separatrix() const { return separatrix_; }
  /// @param direction_P  direction of L, a unit vector in principal axes
  double time_s(const Eigen::Vector3d& direction_P) const;
  double energy(const Eigen::Vector3d& direction_P) const;

 private:
  /// Returns the energy of the polhodes around an extreme axis that take this time; nullopt if all of them take
  /// longer.
  std::optional<double> energyOf(int axis, double time_s) const;

  physics::PrincipalMoments moments_;
  double L_;
  physics::Separatrix separatrix_;
  double least_s_, most_s_;
  bool logarithmic_;
};

}  // namespace poinsot::stage
