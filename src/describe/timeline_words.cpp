// SPDX-License-Identifier: Apache-2.0
#include "describe/timeline_words.h"

#include <fmt/format.h>

#include "core/text.h"
#include "describe/alt_sections.h"
#include "scene/event_kinds.h"
#include "text/math_setter.h"

namespace poinsot::describe {
namespace {

using scene::Moment;
using scene::TimelineEntry;
using Phrases = std::vector<std::string>;

std::string momentWords(const Moment& moment) {
  const std::string around = moment.isMiddle ? "around " : "";
  if (moment.kind == Moment::Kind::kFilm) return moment.isMiddle ? around + timeWords(moment.t_s) : "";
  if (moment.kind == Moment::Kind::kMotion) return fmt::format("{}motion time {}", around, timeWords(moment.t_s));
  const auto kind = static_cast<std::size_t>(moment.event);
  return fmt::format("{}{} {}", around, scene::eventKinds()[kind].word, moment.number);
}

void addCaption(const TimelineEntry& entry, Phrases& phrases) {
  if (!entry.caption) return;
  const std::string plain = text::setTex(*entry.caption).plainText;
  phrases.push_back(plain.empty() ? "no caption" : fmt::format("“{}”", plain));
}

void addPace(const TimelineEntry& entry, Phrases& phrases) {
  if (entry.hold_s > 0) phrases.push_back("pause of " + timeWords(entry.hold_s));
  if (!entry.speed) return;
  phrases.push_back("speed " + numberWords(*entry.speed));
  if (entry.speedFor_s) phrases.back() += " for " + timeWords(*entry.speedFor_s);
}

void addThings(const std::string& verb, const std::vector<int>& things, Phrases& phrases) {
  Phrases names;
  for (const int thing : things) names.push_back(scene::timelineThings()[static_cast<std::size_t>(thing)]);
  if (!names.empty()) phrases.push_back(verb + " " + listWords(names));
}

void addCamera(const TimelineEntry& entry, Phrases& phrases) {
  Phrases moves;
  if (entry.azimuth_rad) moves.push_back("azimuth " + angleWords(*entry.azimuth_rad));
  if (entry.turn_rad != 0) moves.push_back("turn " + angleWords(entry.turn_rad));
  if (entry.elevation_rad) moves.push_back("elevation " + angleWords(*entry.elevation_rad));
  if (entry.zoom) moves.push_back("zoom " + numberWords(*entry.zoom));
  if (!moves.empty()) phrases.push_back("camera " + listWords(moves));
}

std::string entryWords(const TimelineEntry& entry) {
  Phrases phrases;
  addCaption(entry, phrases);
  addPace(entry, phrases);
  addThings("show", entry.shown, phrases);
  addThings("hide", entry.hidden, phrases);
  addCamera(entry, phrases);
  return core::joined(phrases, "; ");
}

}  // namespace

std::vector<TimelineWords> timelineWords(const scene::Scene& scene) {
  std::vector<TimelineWords> words;
  for (const TimelineEntry& entry : scene.timeline.entries)
    words.push_back({entry.at_s, momentWords(entry.moment), entryWords(entry)});
  return words;
}

}  // namespace poinsot::describe
