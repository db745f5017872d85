// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "output/film_reader.h"

namespace poinsot::compare {

/// When the pictures of a film are shown.
class FilmTimes {
 public:
  /// @param step_s  unit in which the film counts its times
  explicit FilmTimes(double step_s) : step_s_(step_s) {}
  void add(const output::ShownPicture& shown);

  std::size_t frames() const { return starts_s_.size(); }
  double step_s() const { return step_s_; }
  /// From the first picture. @pre frame < frames().
  double start_s(std::size_t frame) const { return starts_s_.at(frame) - starts_s_.front(); }
  /// How long the last picture is shown; 0 where the film says nothing.
  double lastFor_s() const { return lastFor_s_; }
  /// Pictures a second of a film that shows each for the same time, but for rounding; 0 for others.
  double steadyRate() const;

 private:
  double step_s_;
  std::vector<double> starts_s_;
  double lastFor_s_ = 0;
};

/// Why two films show their pictures at different times: "frame 45 is at 3.5 s, not 1.5 s". Empty where they agree
/// but for what their containers round, and where one of them has no times. Compares as many frames as both have.
std::string timesMismatch(const FilmTimes& reference, const FilmTimes& test);

}  // namespace poinsot::compare
