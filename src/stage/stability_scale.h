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

/// Region of the sphere of directions of L, around one end of the axis of smallest or largest moment. The outline
/// is a polhode. Directions are unit vectors in principal axes.
struct TimeCap {
  std::vector<Eigen::Vector3d> outline_P;
  std::function<bool(const Eigen::Vector3d&)> contains;
};

/// Colour scale for the time between two flips of a body, over all directions of its L. The scale is linear, or
/// logarithmic if the times differ much.
class StabilityScale {
 public:
  /// @param L  |L|, kg·m²/s. @pre the moments differ, L > 0
  StabilityScale(const physics::PrincipalMoments& moments, double L);

  double least_s() const { return least_s_; }
  /// Returns the longest time with a distinct colour. All longer times have the same colour. They occur within a
  /// degree of the middle axis and along the separatrix.
  double most_s() const { return most_s_; }
  bool isLogarithmic() const { return logarithmic_; }

  /// Returns the position of a time on the scale: 0 at least_s(), 1 at most_s(), more than 1 for longer times.
  double share(double time_s) const;
  double timeAt(double share) const;
  static draw::Color color(double share);

  struct Tick {
    double time_s;
    std::string digits;  ///< time as text, in the unit of the labels
  };
  /// Returns the labelled ticks of the scale. @param perSecond  factor from seconds to the unit of the labels
  std::vector<Tick> ticks(double perSecond) const;

  /// Returns the regions of the sphere where the time is shorter than `time_s`. They surround the ends of the axis
  /// of smallest moment, of the axis of largest moment, or of both.
  std::vector<TimeCap> caps(double time_s) const;

  const physics::Separatrix& separatrix() const { return separatrix_; }
  /// @param direction_P  direction of L, a unit vector in principal axes
  double time_s(const Eigen::Vector3d& direction_P) const;
  double energy(const Eigen::Vector3d& direction_P) const;

 private:
  /// Returns the energy of the polhodes around an axis on which the time between flips is `time_s`. Returns
  /// nullopt if the time is longer on all of them.
  /// @param axis  axis of smallest or largest moment
  std::optional<double> energyOf(int axis, double time_s) const;

  physics::PrincipalMoments moments_;
  double L_;
  physics::Separatrix separatrix_;
  double least_s_, most_s_;
  bool logarithmic_;
};

}  // namespace poinsot::stage
