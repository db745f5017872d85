// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

const Range kFilmTime{.least = 0, .most = usual(Limit::kDuration), .limit = Limit::kDuration};
constexpr Range kOrbits{.least = -36000, .most = 36000, .unit = "deg"};
constexpr Range kMoveElevation{.least = -90, .most = 90, .unit = "deg"};
constexpr Range kMoveZoom{.least = 0.05, .most = 20};
constexpr Range kPace{.least = 0, .most = 100};

template <class F>
Put intoEntry(F place) {
  return into([place](Draft& d, std::size_t i) { return place(elementAt(d.timeline, i)); });
}

std::vector<std::string_view> things() { return {timelineThings().begin(), timelineThings().end()}; }

std::vector<Key> whenKeys() {
  return {
      {.path = "timeline[].at",
       .dimension = kTime,
       .range = kFilmTime,
       .example = "\"4 s\"",
       .help = "Film time at which the changes begin; entries may stand in any order.",
       .put = intoEntry([](TimelineDraft& e) { return &e.at; })},
      {.path = "timeline[].over",
       .dimension = kTime,
       .range = kFilmTime,
       .example = "\"2 s\"",
       .help = "How long the changes take, with a soft start and a soft end; without it 0.8 s.",
       .put = intoEntry([](TimelineDraft& e) { return &e.over; })},
  };
}

std::vector<Key> whatKeys() {
  return {
      {.path = "timeline[].show",
       .type = kWords,
       .words = things(),
       .example = "[\"ellipsoid\", \"plane\"]",
       .help =
           "Things that come, as if drawn on a board; what comes was absent before. They need not be asked for "
           "in [show] besides.",
       .put = intoEntry([](TimelineDraft& e) { return &e.shown; })},
      {.path = "timeline[].hide",
       .type = kWords,
       .words = things(),
       .example = "[\"body\"]",
       .help = "Things that go.",
       .put = intoEntry([](TimelineDraft& e) { return &e.hidden; })},
      {.path = "timeline[].caption",
       .type = kText,
       .range = {.least = 0, .most = 200},
       .example = "'The height $2T/L$ is constant'",
       .help = "Words under the picture, in at most two lines, until the next caption; an empty one ends the one "
               "before. They are written beside the film too, as .srt and .vtt.",
       .isTex = true,
       .put = intoEntry([](TimelineDraft& e) { return &e.caption; })},
      {.path = "timeline[].caption_for",
       .dimension = kTime,
       .range = {.least = 0.1, .most = usual(Limit::kDuration), .limit = Limit::kDuration},
       .example = "\"5 s\"",
       .help = "How long the caption stands; without it until the next one, or the end.",
       .put = intoEntry([](TimelineDraft& e) { return &e.captionFor; })},
  };
}

std::vector<Key> paceKeys() {
  return {
      {.path = "timeline[].speed",
       .range = kPace,
       .example = "0.2",
       .help = "Factor on time.speed from here on: 0.2 is slow motion, 1 as before, 0 a standstill.",
       .put = intoEntry([](TimelineDraft& e) { return &e.speed; })},
      {.path = "timeline[].hold",
       .dimension = kTime,
       .range = kFilmTime,
       .example = "\"2 s\"",
       .help =
           "The motion comes to rest over `over`, stands still that long and goes on; the camera need not stand.",
       .put = intoEntry([](TimelineDraft& e) { return &e.hold; })},
  };
}

std::vector<Key> cameraMoveKeys() {
  return {
      {.path = "timeline[].camera.azimuth",
       .dimension = kAngle,
       .range = kOrbits,
       .example = "\"120 deg\"",
       .help = "Where the camera goes to; it turns the way the number says: from 20 deg to 380 deg is once round.",
       .put = intoEntry([](TimelineDraft& e) { return &e.azimuth; })},
      {.path = "timeline[].camera.turn",
       .dimension = kAngle,
       .range = kOrbits,
       .example = "\"-90 deg\"",
       .help = "In place of azimuth: by how much the camera turns, from wherever it is.",
       .put = intoEntry([](TimelineDraft& e) { return &e.turn; })},
      {.path = "timeline[].camera.elevation",
       .dimension = kAngle,
       .range = kMoveElevation,
       .example = "\"60 deg\"",
       .help = "How far above the horizontal the camera goes.",
       .put = intoEntry([](TimelineDraft& e) { return &e.elevation; })},
      {.path = "timeline[].camera.zoom",
       .range = kMoveZoom,
       .example = "1.6",
       .help = "How close the camera goes: 1 holds the whole motion, seen from wherever it will be.",
       .put = intoEntry([](TimelineDraft& e) { return &e.zoom; })},
  };
}

}  // namespace

std::vector<Key> timelineKeys() { return joined({whenKeys(), whatKeys(), paceKeys(), cameraMoveKeys()}); }

}  // namespace poinsot::scene
