// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/abi.h"
#include "scene/motion/eased_track.h"
#include "scene/timeline.h"

namespace poinsot::scene {

/// Film times from the first to the last at which a film shows one motion time. They differ only if the motion
/// stands still in between.
struct FilmSpan {
  double from_s = 0, to_s = 0;
};

/// Conversion from film time to motion time, including the changes of speed in the timeline. All functions are
/// pure and in closed form, so every worker computes the same bits and no error accumulates over the frames.
class FilmClock {
 public:
  /// @param start_s  motion time at the start of the film
  /// @param speed  motion seconds per film second, before the timeline changes it
  FilmClock(double start_s, double speed, const Timeline& timeline);

  /// Returns the film time at which the same motion would be shown if the timeline did not change the speed. The
  /// result never decreases as filmTime_s grows.
  /// @pre a finite time.
  /// @throws core::Error(kLimit) if the result is beyond the range of numbers.
  double played_s(double filmTime_s) const;
  /// Returns the motion time for a result of played_s().
  /// @throws core::Error(kLimit) if the result is beyond the range of numbers.
  double motionTimeOf(double played_s) const;
  double motionTime_s(double filmTime_s) const { return motionTimeOf(played_s(filmTime_s)); }

  /// Returns the film times at which a film shows the motion at a motion time. Returns nullopt if it never does.
  /// @param duration_s  length of the film
  /// @pre finite times, duration_s >= 0.
  std::optional<FilmSpan> filmTimesOf(double motionTime_s, double duration_s) const;

  /// Returns the factor by which the timeline changes the speed at a film time: 1 for no change, 0 for a pause.
  /// @pre not NaN.
  double pace(double filmTime_s) const;
  bool changes() const { return !pace_.constant(); }
  double fastestPace() const { return pace_.greatest(); }
  /// Returns the speed at pace 1, in motion seconds per film second.
  double speed() const { return speed_; }

 private:
  double start_s_, speed_;
  EasedTrack pace_;
};

static_assert(core::laidOut<FilmSpan, 16>());

}  // namespace poinsot::scene
