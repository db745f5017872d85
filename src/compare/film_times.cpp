// SPDX-License-Identifier: Apache-2.0
#include "compare/film_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poinsot::compare {
namespace {

/// Smallest tolerance, and its growth per frame. FFmpeg's APNG demuxer rounds each duration to 10 us, and these
/// errors add up.
constexpr double kRounding_s = 2e-3, kRoundingPerFrame_s = 5e-6;

double shortest_s(const FilmTimes& film) {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < film.frames(); ++i)
    shortest = std::min(shortest, film.start_s(i) - film.start_s(i - 1));
  return shortest;
}

/// Tolerance for comparing two times of a frame. It covers rounding to the films' time units. It is at most a
/// quarter of the shortest frame, so that no frame is mistaken for its neighbour.
class Allowance {
 public:
  Allowance(const FilmTimes& a, const FilmTimes& b)
      : rounding_s_(std::max(kRounding_s, (a.step_s() + b.step_s()) / 2 + kRoundingPerFrame_s)),
        most_s_(std::min(shortest_s(a), shortest_s(b)) / 4) {}

  bool holds(double a_s, double b_s, std::size_t frame) const {
    const double allowed = std::min(rounding_s_, most_s_) + kRoundingPerFrame_s * static_cast<double>(frame);
    return !(std::abs(a_s - b_s) > allowed);  // a NaN counts as equal
  }

 private:
  double rounding_s_, most_s_;
};

std::string timeText(double time_s) { return fmt::format("{:.12g} s", std::round(time_s * 1e3) / 1e3); }

std::string rateMismatch(const FilmTimes& reference, const FilmTimes& test) {
  const double a = reference.steadyRate(), b = test.steadyRate();
  if (a == 0 || b == 0) return "";
  return fmt::format("the film has {:.4g} frames a second, not {:.4g}", b, a);
}

}  // namespace

void FilmTimes::add(const output::ShownPicture& shown) {
  starts_s_.push_back(shown.start_s);
  lastFor_s_ = shown.duration_s;
}

double FilmTimes::steadyRate() const {
  if (frames() < 2) return 0;
  const std::size_t last = frames() - 1;
  const double each_s = start_s(last) / static_cast<double>(last);
  const Allowance allowance(*this, *this);
  for (std::size_t i = 0; i < frames(); ++i)
    if (!allowance.holds(start_s(i), static_cast<double>(i) * each_s, i)) return 0;
  return 1 / each_s;
}

std::string timesMismatch(const FilmTimes& reference, const FilmTimes& test) {
  const Allowance allowance(reference, test);
  const std::size_t frames = std::min(reference.frames(), test.frames());
  for (std::size_t i = 1; i < frames; ++i) {
    const double a_s = reference.start_s(i), b_s = test.start_s(i);
    if (allowance.holds(a_s, b_s, i)) continue;
    const std::string rate = rateMismatch(reference, test);
    return rate.empty() ? fmt::format("frame {} is at {}, not {}", i, timeText(b_s), timeText(a_s)) : rate;
  }
  const double a_s = reference.lastFor_s(), b_s = test.lastFor_s();
  if (reference.frames() != test.frames() || a_s == 0 || b_s == 0 || allowance.holds(a_s, b_s, 0)) return "";
  return fmt::format("the last frame is shown for {}, not {}", timeText(b_s), timeText(a_s));
}

}  // namespace poinsot::compare
