// SPDX-License-Identifier: Apache-2.0
#include "scene/motion/film_clock.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/expect.h"
#include "physics/motion.h"
#include "scene/motion/first_where.h"

namespace poinsot::scene {
namespace {

struct Change {
  double at_s, over_s, pace;
};

/// Returns the changes of speed in the timeline, sorted by time. An entry with a speed makes one change. A hold
/// makes two changes, to 0 and back, and so does a speed with a duration.
std::vector<Change> changesOf(const Timeline& timeline) {
  std::vector<Change> changes;
  double pace = 1;
  for (const TimelineEntry& entry : timeline.entries) {
    const double before = pace;
    if (entry.speed) pace = *entry.speed;
    if (entry.hold_s > 0) {
      changes.push_back({entry.at_s, entry.over_s, 0});
      changes.push_back({entry.at_s + entry.over_s + entry.hold_s, entry.over_s, pace});
    } else if (entry.speed) {
      changes.push_back({entry.at_s, entry.over_s, pace});
      if (!entry.speedFor_s) continue;
      pace = before;
      changes.push_back({entry.at_s + entry.over_s + *entry.speedFor_s, entry.over_s, pace});
    }
  }
  std::ranges::stable_sort(changes, {}, &Change::at_s);
  return changes;
}

EasedTrack paceOf(const Timeline& timeline) {
  EasedTrack track(1);
  for (const Change& change : changesOf(timeline)) track.turnTo(change.at_s, change.over_s, change.pace);
  return track;
}

double finite(double t_s) {
  if (!std::isfinite(t_s)) physics::refuseTime(t_s);
  return t_s;
}

}  // namespace

FilmClock::FilmClock(double start_s, double speed, const Timeline& timeline)
    : start_s_(start_s), speed_(speed), pace_(paceOf(timeline)) {}

double FilmClock::played_s(double filmTime_s) const {
  POINSOT_EXPECT(std::isfinite(filmTime_s));
  return finite(pace_.integral(filmTime_s));
}

double FilmClock::motionTimeOf(double played_s) const { return finite(start_s_ + speed_ * played_s); }

std::optional<FilmSpan> FilmClock::filmTimesOf(double motionTime_s, double duration_s) const {
  POINSOT_EXPECT(std::isfinite(motionTime_s) && std::isfinite(duration_s) && duration_s >= 0);
  constexpr double kRounding = 1e-15;  // relative; the end of a film is a rounded product
  const double end = played_s(duration_s);
  if (speed_ == 0) return motionTime_s == start_s_ ? std::optional(FilmSpan{0, duration_s}) : std::nullopt;
  double played = (motionTime_s - start_s_) / speed_;
  if (played > end && played - end <= kRounding * (end + std::abs(start_s_ / speed_))) played = end;
  if (!(played >= 0 && played <= end)) return std::nullopt;
  if (!changes()) return FilmSpan{played, played};
  const double first = firstWhere([&](double film_s) { return played_s(film_s) >= played; }, 0, duration_s);
  if (end <= played) return FilmSpan{first, duration_s};
  const double after = firstWhere([&](double film_s) { return played_s(film_s) > played; }, first, duration_s);
  return FilmSpan{first, after - first <= kRounding * duration_s ? first : after};
}

double FilmClock::pace(double filmTime_s) const {
  POINSOT_EXPECT(!std::isnan(filmTime_s));
  return pace_.at(filmTime_s);
}

}  // namespace poinsot::scene
