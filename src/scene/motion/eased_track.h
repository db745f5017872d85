// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/abi.h"

namespace poinsot::scene {

/// A number over film time that goes from one value to the next with a soft start and a soft end: of x in [0, 1]
/// of the way, x³ (10 - 15 x + 6 x²), so that value, velocity and acceleration are continuous. A turn that begins
/// before the last one has ended starts where that one has come to.
class EasedTrack {
 public:
  explicit EasedTrack(double initial);

  /// From `at_s` on the value goes to `target`, which it reaches `over_s` later; at once where that is 0.
  /// @pre no turn before this one is at a later time; at_s >= 0, over_s >= 0.
  void turnTo(double at_s, double over_s, double target);

  double at(double time_s) const;
  /// Of the value from time 0, in closed form. Not below zero where the values are not, and it never falls then.
  double integral(double time_s) const;

  /// Where it goes in the end.
  double target() const { return turns_.back().to; }
  /// It never changes.
  bool constant() const { return turns_.size() == 1; }
  /// Its greatest value: that of a start or an end, for it never goes beyond them.
  double greatest() const;

 private:
  struct Turn {
    double at_s, over_s, from, to;
    double integral;  ///< up to at_s

    /// Whether the value is on its way; never in the first turn, which took place before any time.
    bool turning(double passed_s) const { return passed_s < over_s && over_s > 0; }
    double value(double time_s) const;
    double integralTo(double time_s) const;
  };
  const Turn& turnAt(double time_s) const;

  std::vector<Turn> turns_;  // the first holds the initial value
};

}  // namespace poinsot::scene
