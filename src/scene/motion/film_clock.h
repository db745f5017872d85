// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/motion/eased_track.h"
#include "scene/timeline.h"

namespace poinsot::scene {

/// Conversion from film time to motion time, including a timeline's changes of speed. All functions are pure and
/// in closed form: every worker computes the same bits, and no error accumulates over the frames.
class FilmClock {
 public:
  /// @param start_s  motion time at the start of the film
  /// @param speed  motion seconds per film second, without changes by the timeline
  FilmClock(double start_s, double speed, const Timeline& timeline);

  /// Returns the film time that the same motion would take at plain speed: filmTime_s itself without changes. The
  /// result never falls as filmTime_s grows.
  /// @pre a finite time.
  /// @throws core::Error(kLimit) if the result is beyond the range of numbers.
  double played_s(double filmTime_s) const;
  /// @throws core::Error(kLimit) if the result is beyond the range of numbers.
  double motionTimeOf(double played_s) const;
  double motionTime_s(double filmTime_s) const { return motionTimeOf(played_s(filmTime_s)); }

  /// Returns the factor on the speed at a film time: 1 is plain speed, 0 stands still. @pre not NaN.
  double pace(double filmTime_s) const;
  bool changes() const { return !pace_.constant(); }
  double fastestPace() const { return pace_.greatest(); }
  /// Returns motion seconds per film second at pace 1.
  double speed() const { return speed_; }

 private:
  double start_s_, speed_;
  EasedTrack pace_;
};

}  // namespace poinsot::scene
