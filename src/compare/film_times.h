// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "output/film_reader.h"

namespace poinsot::compare {

/// Times at which the pictures of a film are shown.
class FilmTimes {
 public:
  /// @param step_s  time unit of the film, in seconds
  explicit FilmTimes(double step_s) : step_s_(step_s) {}
  void add(const output::ShownPicture& shown);

  std::size_t frames() const { return starts_s_.size(); }
  double step_s() const { return step_s_; }
  /// Returns a frame's time in seconds after the first frame. @pre frame < frames().
  double start_s(std::size_t frame) const { return starts_s_.at(frame) - starts_s_.front(); }
  /// Returns the duration of the last picture in seconds; 0 if the film does not specify it.
  double lastFor_s() const { return lastFor_s_; }
  /// Returns the frame rate in 1/s if all frames last equally long, except for rounding; otherwise 0.
  double steadyRate() const;

 private:
  double step_s_;
  std::vector<double> starts_s_;
  double lastFor_s_ = 0;
};

/// Describes how the timing of two films differs, such as "frame 45 is at 3.5 s, not 1.5 s". Returns an empty
/// string if the times agree except for the rounding of the containers, or if a film has no times. Compares only
/// frames that both films have.
std::string timesMismatch(const FilmTimes& reference, const FilmTimes& test);

}  // namespace poinsot::compare
