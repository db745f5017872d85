// SPDX-License-Identifier: Apache-2.0
#include "scene/motion/place_timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/error.h"
#include "core/text.h"
#include "scene/motion/film_clock.h"
#include "scene/motion/first_where.h"
#include "scene/motion/make_motion.h"
#include "scene/motion/scene_events.h"

namespace poinsot::scene {
namespace {

using Entries = std::vector<TimelineEntry>;

constexpr double kRounding = 1e-12;  // relative; one entry may begin at the end of another

/// Returns the film time from the begin of an entry to the middle of its slow motion or pause.
double lead_s(const TimelineEntry& entry) { return entry.over_s + entry.lasting_s() / 2; }

/// Returns the film time at which the slow motion or the pause of an entry has ended.
double end_s(const TimelineEntry& entry) { return entry.at_s + 2 * entry.over_s + entry.lasting_s(); }

void insertByTime(Entries& placed, const TimelineEntry& entry) {
  const auto later = std::ranges::find_if(placed, [&](const TimelineEntry& other) {
    return std::pair(entry.at_s, entry.place) < std::pair(other.at_s, other.place);
  });
  placed.insert(later, entry);
}

/// Film time at which an entry begins, or the reason why there is none.
struct Begin {
  std::optional<double> at_s;
  std::string problem{};
};

Begin tooEarly(const TimelineEntry& entry) {
  return {
      {},
      fmt::format("would begin before the film, because its slow motion needs {:g} s up to its middle; shorten "
                  "{} or over",
                  lead_s(entry), entry.hold_s > 0 ? "hold" : "speed_for")};
}

/// Computes the film times of the entries of one timeline.
class Placement {
 public:
  explicit Placement(const Scene& scene)
      : scene_(scene), speed_(chosenSpeed(scene)), duration_s_(scene.time.duration_s) {}

  Entries run() {
    Entries open;
    for (const TimelineEntry& entry : scene_.timeline.entries)
      if (entry.moment.kind == Moment::Kind::kFilm)
        place(entry, beginInFilm(entry));
      else
        open.push_back(entry);
    while (!open.empty()) placeNext(open);
    checkOverlaps();
    return std::move(placed_);
  }

  std::vector<MomentProblem> problems() && { return std::move(problems_); }

 private:
  void refuse(const TimelineEntry& entry, std::string message) {
    problems_.push_back({entry.place, std::move(message)});
  }

  void place(TimelineEntry entry, Begin begin) {
    if (!begin.at_s) return refuse(entry, std::move(begin.problem));
    entry.at_s = *begin.at_s;
    insertByTime(placed_, entry);
  }

  /// Places the open entry that begins first: the entries that begin later do not move it. If no open entry can
  /// begin, refuses all.
  void placeNext(Entries& open) {
    std::vector<Begin> begins;
    for (const TimelineEntry& entry : open) begins.push_back(beginOf(entry));
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < open.size(); ++i)
      if (begins[i].at_s && (!first || *begins[i].at_s < *begins[*first].at_s)) first = i;
    if (first) {
      place(open[*first], begins[*first]);
      open.erase(open.begin() + static_cast<std::ptrdiff_t>(*first));
      return;
    }
    for (std::size_t i = 0; i < open.size(); ++i) refuse(open[i], std::move(begins[i].problem));
    open.clear();
  }

  static Begin beginInFilm(const TimelineEntry& entry) {
    const double at_s = entry.moment.t_s - (entry.moment.isMiddle ? lead_s(entry) : 0);
    return at_s < 0 ? tooEarly(entry) : Begin{at_s};
  }

  FilmClock clockWith(const Entries& entries) const { return {scene_.time.start_s, speed_, {entries, {}}}; }

  Begin beginOf(const TimelineEntry& entry) {
    if (speed_ == 0) return {{}, "the motion stands still, because time.speed is 0; give a film time"};
    const FilmClock clock = clockWith(placed_);
    try {
      const auto motion_s = motionTimeOf(entry.moment);
      const auto film = motion_s ? clock.filmTimesOf(*motion_s, duration_s_) : std::nullopt;
      if (!film) return {{}, absent(entry.moment, clock)};
      return entry.moment.isMiddle ? beginAround(entry, *motion_s, film->from_s) : Begin{film->from_s};
    } catch (const core::Error& error) {
      return {{}, error.message()};
    }
  }

  /// Returns the film time at which an entry must begin so that its middle shows a motion time. The entry can only
  /// begin after the slow motion or the pause before it.
  /// @param shown_s  film time of the motion time without this entry
  Begin beginAround(TimelineEntry entry, double motion_s, double shown_s) const {
    const TimelineEntry* before = nullptr;
    for (const TimelineEntry& other : placed_)
      if (other.lasting_s() > 0 && other.at_s <= shown_s) before = &other;
    const double free_s = before ? end_s(*before) : 0;
    const double wanted = (motion_s - scene_.time.start_s) / speed_;
    const auto playedAtMiddle = [&](double at_s) {
      entry.at_s = at_s;
      Entries entries = placed_;
      insertByTime(entries, entry);
      return clockWith(entries).played_s(at_s + lead_s(entry));
    };
    if (before && (free_s > shown_s || playedAtMiddle(free_s) > wanted))
      return {
          {},
          fmt::format("would begin while the slow motion or pause of timeline[{}] lasts, from {:.4g} s to {:.4g} "
                      "s; shorten one of the two",
                      before->place, before->at_s, free_s)};
    if (playedAtMiddle(free_s) > wanted) return tooEarly(entry);
    const double last_s = std::min(shown_s, duration_s_ - lead_s(entry));
    if (last_s < free_s || playedAtMiddle(last_s) < wanted)
      return {{}, "the film ends before the middle of this slow motion; make time.duration longer"};
    return {firstWhere([&](double at_s) { return playedAtMiddle(at_s) >= wanted; }, free_s, last_s)};
  }

  std::optional<double> motionTimeOf(const Moment& moment) {
    if (moment.kind == Moment::Kind::kMotion) return moment.t_s;
    int number = 0;
    for (const SceneEvent& event : events())
      if (event.kind == moment.event && ++number == moment.number) return event.t_s;
    return std::nullopt;
  }

  /// Returns the events of the motion up to the last time that the film can reach.
  /// @throws core::Error as makeMotion() and sceneEvents()
  const std::vector<SceneEvent>& events() {
    if (events_) return *events_;
    double fastest = 1;
    for (const TimelineEntry& entry : scene_.timeline.entries)
      fastest = std::max(fastest, entry.speed.value_or(1));
    const double start_s = scene_.time.start_s, end_s = start_s + speed_ * duration_s_ * fastest;
    const auto motion = makeMotion(scene_, start_s, end_s);
    events_ = sceneEvents(scene_, *motion, clockWith({}), {start_s, end_s});
    return *events_;
  }

  /// Returns the message for a moment that the film does not show.
  std::string absent(const Moment& moment, const FilmClock& clock) {
    if (moment.kind == Moment::Kind::kMotion)
      return fmt::format("the film shows the motion from {:g} s to {:g} s, got {:g} s", scene_.time.start_s,
                         clock.motionTime_s(duration_s_), moment.t_s);
    std::map<int, int> counts;
    for (const SceneEvent& event : events())
      if (clock.filmTimesOf(event.t_s, duration_s_)) ++counts[event.kind];
    std::vector<std::string> shown;
    for (const auto& [kind, count] : counts)
      shown.push_back(fmt::format("{} {}", wordOf(kind), count == 1 ? "1" : fmt::format("1 to {}", count)));
    return fmt::format("the film has no {} {}; it has {}", wordOf(moment.event), moment.number,
                       shown.empty() ? "no events" : core::joined(shown, ", "));
  }

  static std::string_view wordOf(int kind) { return eventKinds()[static_cast<std::size_t>(kind)].word; }

  /// Refuses a change of speed that begins while an earlier entry sets the speed for a limited time: the end of
  /// the earlier one would cancel it.
  void checkOverlaps() {
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      const TimelineEntry& first = placed_[i];
      if (first.lasting_s() == 0) continue;
      for (std::size_t k = i + 1; k < placed_.size() && placed_[k].at_s < end_s(first) * (1 - kRounding); ++k)
        if (placed_[k].changesSpeed())
          refuse(placed_[k],
                 fmt::format("changes the speed at {:.4g} s, but the {} of timeline[{}] lasts from {:.4g} "
                             "s to {:.4g} s",
                             placed_[k].at_s, first.hold_s > 0 ? "pause" : "slow motion", first.place, first.at_s,
                             end_s(first)));
    }
  }

  const Scene& scene_;
  double speed_, duration_s_;
  Entries placed_;  // sorted by time
  std::optional<std::vector<SceneEvent>> events_;
  std::vector<MomentProblem> problems_;
};

/// Returns the captions of the film. Each lasts until the next caption begins, or for the time that the scene
/// gives. A caption without text only ends the previous caption.
std::vector<Caption> captionsOf(const Entries& byTime, double duration_s) {
  std::vector<Caption> captions;
  for (const TimelineEntry& entry : byTime) {
    if (!entry.caption) continue;
    if (!captions.empty()) captions.back().to_s = std::min(captions.back().to_s, entry.at_s);
    const double end_s = entry.captionFor_s ? std::min(duration_s, entry.at_s + *entry.captionFor_s) : duration_s;
    captions.push_back({entry.at_s, end_s, *entry.caption});
  }
  std::erase_if(captions,
                [](const Caption& caption) { return caption.text.empty() || !(caption.to_s > caption.from_s); });
  return captions;
}

}  // namespace

std::vector<MomentProblem> placeTimeline(Scene& scene) {
  Placement placement(scene);
  scene.timeline.entries = placement.run();
  scene.timeline.captions = captionsOf(scene.timeline.entries, scene.time.duration_s);
  return std::move(placement).problems();
}

}  // namespace poinsot::scene
