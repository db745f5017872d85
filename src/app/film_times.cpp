// SPDX-License-Identifier: Apache-2.0
#include "app/film_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poinsot::app {
namespace {

/// Times as they are after a way through other containers: WebM rounds to 1 ms, and FFmpeg's reader of APNG rounds
/// each duration to 10 us, which adds up.
constexpr double kRounding_s = 2e-3, kRoundingPerFrame_s = 5e-6;

/// How far two times of a frame may be apart.
double allowance_s(double steps_s, std::size_t frame) {
  return std::max(kRounding_s, steps_s) + kRoundingPerFrame_s * static_cast<double>(frame);
}

bool isNear(double a_s, double b_s, double steps_s, std::size_t frame) {
  return !(std::abs(a_s - b_s) > allowance_s(steps_s, frame));  // what is no number is no difference
}

/// To the millisecond.
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
  for (std::size_t i = 0; i < frames(); ++i)
    if (!isNear(start_s(i), static_cast<double>(i) * each_s, step_s_, i)) return 0;
  return 1 / each_s;
}

std::string timesMismatch(const FilmTimes& reference, const FilmTimes& test) {
  const double steps_s = reference.step_s() + test.step_s();
  const std::size_t frames = std::min(reference.frames(), test.frames());
  for (std::size_t i = 1; i < frames; ++i) {
    const double a_s = reference.start_s(i), b_s = test.start_s(i);
    if (isNear(a_s, b_s, steps_s, i)) continue;
    const std::string rate = rateMismatch(reference, test);
    return rate.empty() ? fmt::format("frame {} is at {}, not {}", i, timeText(b_s), timeText(a_s)) : rate;
  }
  const double a_s = reference.lastFor_s(), b_s = test.lastFor_s();
  if (reference.frames() != test.frames() || a_s == 0 || b_s == 0 || isNear(a_s, b_s, steps_s, 0)) return "";
  return fmt::format("the last frame is shown for {}, not {}", timeText(b_s), timeText(a_s));
}

}  // namespace poinsot::app
