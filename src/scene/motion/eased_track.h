// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/abi.h"

namespace poinsot::scene {

/// Value that depends on film time, such as an angle of the camera. It moves to each new target with a soft start
/// and a soft end: after the fraction x of the duration, it has covered x³ (10 - 15 x + 6 x²) of the distance.
/// Velocity and acceleration are 0 at both ends. A move that begins before the previous move has ended starts from
/// the value reached so far.
class EasedTrack {
 public:
  explicit EasedTrack(double initial);

  /// Adds a move to `target`, which begins at `at_s` and lasts for `over_s`; the value jumps if `over_s` is 0.
  /// @pre no turn before this one is at a later time; at_s >= 0, over_s >= 0.
  void turnTo(double at_s, double over_s, double target);

  double at(double time_s) const;
  /// Returns the integral of the value from time 0 to `time_s`, in closed form. If the value is never negative,
  /// the integral is never negative and never decreases.
  double integral(double time_s) const;

  double target() const { return turns_.back().to; }
  bool constant() const { return turns_.size() == 1; }
  /// Returns the largest value, which is a start or a target of a move, because the track never overshoots.
  double greatest() const;

 private:
  struct Turn {
    double at_s, over_s, from, to;
    double integral;  ///< integral of the value from time 0 to at_s

    /// Returns whether the value is moving at the time passed_s after at_s. Always false for the initial value.
    bool turning(double passed_s) const { return passed_s < over_s && over_s > 0; }
    double value(double time_s) const;
    double integralTo(double time_s) const;
  };
  const Turn& turnAt(double time_s) const;

  std::vector<Turn> turns_;  // the first element is the initial value, not a move
};

}  // namespace poinsot::scene
