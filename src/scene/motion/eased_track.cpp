// SPDX-License-Identifier: Apache-2.0
#include "scene/motion/eased_track.h"

#include <algorithm>

#include "core/expect.h"

namespace poinsot::scene {
namespace {

double eased(double x) { return x * x * x * (10 - x * (15 - 6 * x)); }

// Returns the integral of eased() from 0 to x. From 0 to 1 it is 1/2.
double easedIntegral(double x) { return x * x * x * x * (2.5 - x * (3 - x)); }

}  // namespace

EasedTrack::EasedTrack(double initial) : turns_{{0, 0, initial, initial, 0}} {}

void EasedTrack::turnTo(double at_s, double over_s, double target) {
  POINSOT_EXPECT(at_s >= turns_.back().at_s && over_s >= 0);
  turns_.push_back({at_s, over_s, at(at_s), target, integral(at_s)});
}

const EasedTrack::Turn& EasedTrack::turnAt(double time_s) const {
  const auto later = std::upper_bound(turns_.begin() + 1, turns_.end(), time_s,
                                      [](double t, const Turn& turn) { return t < turn.at_s; });
  return *(later - 1);
}

double EasedTrack::at(double time_s) const { return turnAt(time_s).value(time_s); }

double EasedTrack::integral(double time_s) const { return turnAt(time_s).integralTo(time_s); }

double EasedTrack::greatest() const {
  double most = turns_.front().to;
  for (const Turn& turn : turns_) most = std::max({most, turn.from, turn.to});
  return most;
}

double EasedTrack::Turn::value(double time_s) const {
  const double passed_s = time_s - at_s;
  return turning(passed_s) ? from + (to - from) * eased(passed_s / over_s) : to;
}

double EasedTrack::Turn::integralTo(double time_s) const {
  const double passed_s = time_s - at_s;
  if (turning(passed_s))
    return integral + from * passed_s + (to - from) * over_s * easedIntegral(passed_s / over_s);
  return integral + 0.5 * (from + to) * over_s + to * (passed_s - over_s);
}

}  // namespace poinsot::scene
