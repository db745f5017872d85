// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/motion/eased_track.h"
#include "scene/timeline.h"

namespace poinsot::scene {

/// From film time to motion time, through a timeline's changes of speed. Pure functions in closed form: every
/// worker has the same bits, and nothing accumulates from frame to frame.
class FilmClock {
 public:
  /// @param start_s  motion time of the film's beginning
  /// @param speed  motion seconds per film second where the timeline changes nothing
  FilmClock(double start_s, double speed, const Timeline& timeline);

  /// How long the film would have taken to here at its plain speed: the film time itself without changes. It never
  /// falls. @pre a finite time. @throws core::Error(kLimit) where the result is beyond the range of numbers.
  double played_s(double filmTime_s) const;
  /// @throws core::Error(kLimit) where the result is beyond the range of numbers.
  double motionTimeOf(double played_s) const;
  double motionTime_s(double filmTime_s) const { return motionTimeOf(played_s(filmTime_s)); }

  /// The factor on the speed at a film time: 1 plain, 0 stands still. @pre not NaN.
  double pace(double filmTime_s) const;
  bool changes() const { return !pace_.constant(); }
  /// The largest factor of the film.
  double fastestPace() const { return pace_.greatest(); }
  /// Motion seconds per film second at pace 1.
  double speed() const { return speed_; }

 private:
  double start_s_, speed_;
  EasedTrack pace_;
};

}  // namespace poinsot::scene
