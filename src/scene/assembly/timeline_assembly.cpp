// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/motion/place_timeline.h"

namespace poinsot::scene {
namespace {

std::string pathOf(std::size_t entry) { return fmt::format("timeline[{}]", entry); }

/// Returns entry i of the timeline, or a default entry if the draft has none because no key of the entry is valid.
TimelineDraft given(const Draft& draft, std::size_t i) {
  return i < draft.timeline.size() ? draft.timeline[i] : TimelineDraft();
}

constexpr double kSpeedAround_s = 2;  // default of speed_for with `around`

/// Checks the moment of an entry and returns it. If there is none, reports this and returns nullopt.
std::optional<Moment> momentOf(const TimelineDraft& entry, const std::string& path, double duration_s,
                               Findings& findings) {
  const std::string at = path + ".at", motion = path + ".at_motion", around = path + ".around";
  std::string_view first;
  for (const std::string& one : {at, motion, around}) {
    if (!findings.has(one)) continue;
    if (!first.empty()) findings.refuse(one, fmt::format("{} is given too; an entry has one moment", first));
    if (first.empty()) first = one == at ? at : one == motion ? motion : around;
  }
  if (first.empty()) findings.refuseMissing(at, path, "at is required: the film time of this entry");
  if (entry.atMotion) return Moment{Moment::Kind::kMotion, *entry.atMotion};
  const std::optional<Moment>& moment = entry.at ? entry.at : entry.around;
  if (moment && moment->kind == Moment::Kind::kFilm && moment->t_s > duration_s)
    findings.refuse(
        first, fmt::format("must lie within the film, which ends at {:g} s, got {:g} s", duration_s, moment->t_s));
  return moment;
}

/// Adds a note if a slow motion or a pause lasts longer than the film, which cuts it off.
void doubtLasting(const TimelineEntry& entry, double duration_s, Findings& findings) {
  const double end_s = entry.at_s + entry.over_s + entry.lasting_s();
  if (entry.lasting_s() == 0 || entry.at_s > duration_s || end_s <= duration_s) return;
  findings.doubt(
      pathOf(entry.place) + (entry.hold_s > 0 ? ".hold" : ".speed_for"),
      fmt::format("would last until {:g} s, but the film ends at {:g} s (time.duration)", end_s, duration_s));
}

void checkWhat(const TimelineDraft& entry, const std::string& path, Findings& findings) {
  for (const int thing : entry.shown)
    if (std::ranges::find(entry.hidden, thing) != entry.hidden.end())
      findings.refuse(path + ".hide",
                      fmt::format("\"{}\" is in both show and hide of this entry; leave out one of the two",
                                  timelineThings()[static_cast<std::size_t>(thing)]));
  if (entry.captionFor && !findings.has(path + ".caption"))
    findings.refuse(path + ".caption_for", "has no effect without a caption; give caption too");
  if (entry.speedFor && !findings.has(path + ".speed"))
    findings.refuse(path + ".speed_for", "has no effect without a speed; give speed too");
  if (entry.speedFor && entry.hold)
    findings.refuse(path + ".hold", "cannot be combined with speed_for; give one of the two");
  if (entry.around && !findings.has(path + ".speed") && !findings.has(path + ".hold"))
    findings.refuse(path + ".around", "needs a slow motion or a pause to be in its middle; give speed or hold");
  if (entry.azimuth && entry.turn)
    findings.refuse(path + ".camera.turn",
                    "cannot be combined with camera.azimuth; give the new azimuth, or the angle to turn by");
}

TimelineEntry entryOf(const TimelineDraft& given, std::size_t place, const Moment& moment) {
  TimelineEntry entry;
  entry.place = place;
  entry.moment = moment;
  entry.at_s = moment.t_s;
  entry.over_s = given.over.value_or(entry.over_s);
  entry.shown = given.shown;
  entry.hidden = given.hidden;
  entry.speed = given.speed;
  entry.speedFor_s = given.speedFor;
  entry.hold_s = given.hold.value_or(0);
  if (moment.isMiddle && entry.speed && !entry.speedFor_s && entry.hold_s == 0) entry.speedFor_s = kSpeedAround_s;
  entry.azimuth_rad = given.azimuth;
  entry.elevation_rad = given.elevation;
  entry.zoom = given.zoom;
  entry.turn_rad = given.turn.value_or(0);
  entry.caption = given.caption;
  entry.captionFor_s = given.captionFor;
  return entry;
}

/// Adds notes for captions that the next caption hides, in part or completely.
void doubtCaptions(const std::vector<TimelineEntry>& byTime, Findings& findings) {
  const TimelineEntry* before = nullptr;
  for (const TimelineEntry& entry : byTime) {
    if (!entry.caption) continue;
    const bool shown = before && !before->caption->empty();
    if (shown && before->at_s == entry.at_s)
      findings.doubt(pathOf(before->place) + ".caption",
                     fmt::format("is never shown, because {}.caption also begins at {:g} s", pathOf(entry.place),
                                 entry.at_s));
    else if (shown && before->captionFor_s && before->at_s + *before->captionFor_s > entry.at_s)
      findings.doubt(pathOf(before->place) + ".caption_for",
                     fmt::format("would last until {:g} s, but {}.caption replaces this caption at {:g} s",
                                 before->at_s + *before->captionFor_s, pathOf(entry.place), entry.at_s));
    before = &entry;
  }
}

/// Adds notes for captions that disappear before they can be read.
void doubtShortCaptions(const Timeline& timeline, Findings& findings) {
  constexpr double kWord_s = 0.25;  // fast readers read a word in this time
  for (const Caption& caption : timeline.captions) {
    const auto words = 1 + std::ranges::count(caption.text, ' ');
    const double shown_s = caption.to_s - caption.from_s;
    if (shown_s >= kWord_s * static_cast<double>(words)) continue;
    const auto entry = std::ranges::find_if(timeline.entries, [&](const TimelineEntry& each) {
      return each.caption == caption.text && each.at_s == caption.from_s;
    });
    findings.doubt(pathOf(entry->place) + ".caption",
                   fmt::format("is shown for only {:.2g} s, which is short for {} words", shown_s, words));
  }
}

/// Places the entries in the film. Reports entries without a place, and doubtful ones.
void place(Scene& scene, double duration_s, Findings& findings) {
  for (const MomentProblem& problem : placeTimeline(scene)) {
    const std::string path = pathOf(problem.place);
    const bool isMotion = findings.has(path + ".at_motion"), isAround = findings.has(path + ".around");
    findings.refuse(path + (isMotion ? ".at_motion" : isAround ? ".around" : ".at"), problem.message);
  }
  for (const TimelineEntry& entry : scene.timeline.entries) doubtLasting(entry, duration_s, findings);
  doubtCaptions(scene.timeline.entries, findings);
  doubtShortCaptions(scene.timeline, findings);
}

}  // namespace

void askForShown(Draft& draft, const Findings& findings) {
  for (const TimelineDraft& entry : std::vector(draft.timeline))
    for (const int thing : entry.shown) {
      const std::string path = fmt::format("show.{}.visible", timelineThings()[static_cast<std::size_t>(thing)]);
      if (const Key* key = findKey(path); key && !findings.has(path)) key->put(draft, 0, Checked(true));
    }
}

void assembleTimeline(const Draft& draft, Findings& findings, Scene& scene) {
  // If the duration is invalid, no entry is reported as beyond the end of the film.
  const double end_s = findings.isUnsure("time.duration") ? HUGE_VAL : scene.time.duration_s;
  bool refersToMotion = false;
  for (std::size_t i = 0; i < findings.count("timeline"); ++i) {
    const TimelineDraft entry = given(draft, i);
    const auto moment = momentOf(entry, pathOf(i), end_s, findings);
    checkWhat(entry, pathOf(i), findings);
    if (!moment) continue;
    scene.timeline.entries.push_back(entryOf(entry, i, *moment));
    refersToMotion = refersToMotion || moment->kind != Moment::Kind::kFilm;
  }
  if (!refersToMotion || findings.none()) place(scene, end_s, findings);
}

}  // namespace poinsot::scene
