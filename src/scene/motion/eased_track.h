// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/abi.h"

namespace poinsot::scene {

/// Value over film time that moves to new targets with a soft start and a soft end. At the fraction x of a turn's
/// duration it has come x³ (10 - 15 x + 6 x²) of the way, so value, velocity and acceleration are continuous. A
/// turn that begins before the last one has ended starts from the value reached so far.
class EasedTrack {
 public:
  explicit EasedTrack(double initial);

  /// Moves the value from time `at_s` on to `target`, which it reaches `over_s` later; at once if `over_s` is 0.
  /// @pre no turn before this one is at a later time; at_s >= 0, over_s >= 0.
  void turnTo(double at_s, double over_s, double target);

  double at(double time_s) const;
  /// Returns the integral of the value from time 0, in closed form. If no value is negative, the integral is not
  /// negative and never falls.
  double integral(double time_s) const;

  double target() const { return turns_.back().to; }
  bool constant() const { return turns_.size() == 1; }
  /// Returns the largest value. Only starts and targets count, because the track never overshoots.
  double greatest() const;

 private:
  struct Turn {
    double at_s, over_s, from, to;
    double integral;  ///< integral of the value from time 0 to at_s

    /// Returns whether the value is still moving; always false in the first turn, which only holds the initial
    /// value.
    bool turning(double passed_s) const { return passed_s < over_s && over_s > 0; }
    double value(double time_s) const;
    double integralTo(double time_s) const;
  };
  const Turn& turnAt(double time_s) const;

  std::vector<Turn> turns_;  // the first holds the initial value
};

}  // namespace poinsot::scene
