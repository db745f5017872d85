// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poinsot::scene {
namespace {

std::string pathOf(std::size_t entry) { return fmt::format("timeline[{}]", entry); }

/// Returns entry i of the timeline, or a default entry if the draft has none because no key of the entry is valid.
TimelineDraft given(const Draft& draft, std::size_t i) {
  return i < draft.timeline.size() ? draft.timeline[i] : TimelineDraft();
}

void checkWhen(const TimelineDraft& entry, const std::string& path, double duration_s, Findings& findings) {
  if (!entry.at && !findings.has(path + ".at"))
    findings.refuseMissing(path + ".at", path, "at is required: the film time of this entry");
  if (entry.at && *entry.at > duration_s)
    findings.refuse(path + ".at", fmt::format("must lie within the film, which ends at {:g} s, got {:g} s",
                                              duration_s, *entry.at));
}

/// Adds a note if a pause of the motion lasts longer than the film, which cuts the pause off.
void doubtHold(const TimelineDraft& entry, const std::string& path, double duration_s, Findings& findings) {
  if (!entry.hold || !entry.at || *entry.at > duration_s) return;
  const double end_s = *entry.at + entry.over.value_or(TimelineEntry().over_s) + *entry.hold;
  if (end_s > duration_s)
    findings.doubt(
        path + ".hold",
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
  if (entry.azimuth && entry.turn)
    findings.refuse(path + ".camera.turn",
                    "cannot be combined with camera.azimuth; give the new azimuth, or the angle to turn by");
}

TimelineEntry entryOf(const TimelineDraft& given) {
  TimelineEntry entry;
  entry.at_s = *given.at;
  entry.over_s = given.over.value_or(entry.over_s);
  entry.shown = given.shown;
  entry.hidden = given.hidden;
  entry.speed = given.speed;
  entry.hold_s = given.hold.value_or(0);
  entry.azimuth_rad = given.azimuth;
  entry.elevation_rad = given.elevation;
  entry.zoom = given.zoom;
  entry.turn_rad = given.turn.value_or(0);
  return entry;
}

/// Returns the captions of the film. Each lasts until the next caption begins, or for the time that the scene
/// gives. A caption without text only ends the previous caption.
std::vector<Caption> captionsOf(const std::vector<TimelineDraft>& byTime, double duration_s) {
  std::vector<Caption> captions;
  for (const TimelineDraft& entry : byTime) {
    if (!entry.caption) continue;
    if (!captions.empty()) captions.back().to_s = std::min(captions.back().to_s, *entry.at);
    const double end_s = entry.captionFor ? std::min(duration_s, *entry.at + *entry.captionFor) : duration_s;
    captions.push_back({*entry.at, end_s, *entry.caption});
  }
  std::erase_if(captions,
                [](const Caption& caption) { return caption.text.empty() || !(caption.to_s > caption.from_s); });
  return captions;
}

/// Adds notes for captions that the next caption hides, in part or completely.
/// @param byTime  indices of the entries with a time, in the order of time
void doubtCaptions(const std::vector<TimelineDraft>& entries, const std::vector<std::size_t>& byTime,
                   Findings& findings) {
  std::optional<std::size_t> before;
  for (const std::size_t i : byTime) {
    if (!entries[i].caption) continue;
    const TimelineDraft* earlier = before ? &entries[*before] : nullptr;
    const bool shown = earlier && !earlier->caption->empty();
    if (shown && *earlier->at == *entries[i].at)
      findings.doubt(
          pathOf(*before) + ".caption",
          fmt::format("is never shown, because {}.caption also begins at {:g} s", pathOf(i), *entries[i].at));
    else if (shown && earlier->captionFor && *earlier->at + *earlier->captionFor > *entries[i].at)
      findings.doubt(pathOf(*before) + ".caption_for",
                     fmt::format("would last until {:g} s, but {}.caption replaces this caption at {:g} s",
                                 *earlier->at + *earlier->captionFor, pathOf(i), *entries[i].at));
    before = i;
  }
}

}  // namespace

void askForShown(Draft& draft, const Findings& findings) {
  for (const TimelineDraft& entry : std::vector(draft.timeline))
    for (const int thing : entry.shown) {
      const std::string path = fmt::format("show.{}.visible", timelineThings()[static_cast<std::size_t>(thing)]);
      if (const Key* key = findKey(path); key && !findings.has(path)) key->put(draft, 0, Checked(true));
    }
}

Timeline assembleTimeline(const Draft& draft, double duration_s, Findings& findings) {
  // If the duration is invalid, no entry is reported as beyond the end of the film.
  const double end_s = findings.isUnsure("time.duration") ? HUGE_VAL : duration_s;
  std::vector<TimelineDraft> all, entries;
  std::vector<std::size_t> byTime;
  for (std::size_t i = 0; i < findings.count("timeline"); ++i) {
    const TimelineDraft entry = given(draft, i);
    checkWhen(entry, pathOf(i), end_s, findings);
    checkWhat(entry, pathOf(i), findings);
    doubtHold(entry, pathOf(i), end_s, findings);
    all.push_back(entry);
    if (entry.at) byTime.push_back(i);
  }
  std::ranges::stable_sort(byTime, {}, [&](std::size_t i) { return *all[i].at; });
  doubtCaptions(all, byTime, findings);
  for (const std::size_t i : byTime) entries.push_back(all[i]);
  Timeline timeline{{}, captionsOf(entries, duration_s)};
  for (const TimelineDraft& entry : entries) timeline.entries.push_back(entryOf(entry));
  return timeline;
}

}  // namespace poinsot::scene
