// SPDX-License-Identifier: Apache-2.0
#include "scene/event_kinds.h"
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

std::vector<std::string_view> events() {
  std::vector<std::string_view> words;
  for (const EventKind& kind : eventKinds()) words.push_back(kind.word);
  return words;
}

Moment momentOf(const Checked& value, bool isMiddle) {
  if (const auto* event = std::get_if<NumberedWord>(&value))
    return {Moment::Kind::kEvent, 0, event->index, event->number, isMiddle};
  return {Moment::Kind::kFilm, std::get<double>(value), 0, 1, isMiddle};
}

Key momentKey(std::string path, std::string_view example, std::string_view help,
              std::optional<Moment> TimelineDraft::*moment, bool isMiddle) {
  return {.path = "timeline[]." + path,
          .type = kMoment,
          .dimension = kTime,
          .range = kFilmTime,
          .words = events(),
          .example = example,
          .help = help,
          .put = [moment, isMiddle](Draft& d, std::size_t i, const Checked& value) {
            elementAt(d.timeline, i).*moment = momentOf(value, isMiddle);
          }};
}

std::vector<Key> whenKeys() {
  return {
      momentKey("at", "\"4 s\"",
                "Film time at which the changes of this timeline entry begin, or an event of the motion, such as "
                "\"flip 2\". Events are counted from the begin of the film, in the order in which the film shows "
                "them; `info` lists them. The entries of a timeline may be in any order.",
                &TimelineDraft::at, false),
      {.path = "timeline[].at_motion",
       .dimension = kTime,
       .range = kInstants,
       .example = "\"6 s\"",
       .help = "Motion time at which the changes of this timeline entry begin, instead of `at`.",
       .put = intoEntry([](TimelineDraft& e) { return &e.atMotion; })},
      momentKey("around", "\"flip 1\"",
                "Film time or event in the middle of a slow motion or a pause, instead of `at`. The entry begins "
                "so early that the film shows this moment half-way through `speed_for`, or during `hold`.",
                &TimelineDraft::around, true),
      {.path = "timeline[].over",
       .dimension = kTime,
       .range = kFilmTime,
       .example = "\"2 s\"",
       .help = "Duration of the changes of this timeline entry, which start and end softly. The default is 0.8 s.",
       .put = intoEntry([](TimelineDraft& e) { return &e.over; })},
  };
}

std::vector<Key> whatKeys() {
  return {
      {.path = "timeline[].show",
       .type = kWords,
       .words = things(),
       .example = "[\"ellipsoid\", \"plane\"]",
       .help = "Parts of the picture that appear with this entry, as if drawn on a board. Before this entry, they "
               "are hidden. You need not turn them on in [show].",
       .put = intoEntry([](TimelineDraft& e) { return &e.shown; })},
      {.path = "timeline[].hide",
       .type = kWords,
       .words = things(),
       .example = "[\"body\"]",
       .help = "Things that disappear.",
       .put = intoEntry([](TimelineDraft& e) { return &e.hidden; })},
      {.path = "timeline[].caption",
       .type = kText,
       .range = {.least = 0, .most = 200},
       .example = "'The height $2T/L$ is constant'",
       .help = "Caption under the picture, in at most two lines. The caption stays until the next caption. An "
               "empty caption ends the caption before. poinsot also writes all captions to .srt and .vtt files "
               "beside the film.",
       .isTex = true,
       .put = intoEntry([](TimelineDraft& e) { return &e.caption; })},
      {.path = "timeline[].caption_for",
       .dimension = kTime,
       .range = {.least = 0.1, .most = usual(Limit::kDuration), .limit = Limit::kDuration},
       .example = "\"5 s\"",
       .help =
           "Duration of the caption. By default, the caption stays until the next caption or the end of the film.",
       .put = intoEntry([](TimelineDraft& e) { return &e.captionFor; })},
  };
}

std::vector<Key> paceKeys() {
  return {
      {.path = "timeline[].speed",
       .range = kPace,
       .example = "0.2",
       .help =
           "Factor on time.speed from this entry on: 0.2 is slow motion, 1 is normal speed, 0 is a standstill.",
       .put = intoEntry([](TimelineDraft& e) { return &e.speed; })},
      {.path = "timeline[].speed_for",
       .dimension = kTime,
       .range = {.least = 0, .most = usual(Limit::kDuration), .limit = Limit::kDuration},
       .example = "\"4 s\"",
       .help = "Duration of `speed`, after which the speed from before this entry returns. By default, the speed "
               "stays until a later entry changes it; with `around`, the default is 2 s.",
       .put = intoEntry([](TimelineDraft& e) { return &e.speedFor; })},
      {.path = "timeline[].hold",
       .dimension = kTime,
       .range = kFilmTime,
       .example = "\"2 s\"",
       .help = "Duration of a standstill of the motion. The motion slows down during `over`, stands still this "
               "long and then goes on. The camera may move during the standstill.",
       .put = intoEntry([](TimelineDraft& e) { return &e.hold; })},
  };
}

std::vector<Key> cameraMoveKeys() {
  return {
      {.path = "timeline[].camera.azimuth",
       .dimension = kAngle,
       .range = kOrbits,
       .example = "\"120 deg\"",
       .help = "Azimuth to which the camera turns. The number also gives the way that the camera takes: from 20 "
               "deg to 380 deg, it makes one full turn.",
       .put = intoEntry([](TimelineDraft& e) { return &e.azimuth; })},
      {.path = "timeline[].camera.turn",
       .dimension = kAngle,
       .range = kOrbits,
       .example = "\"-90 deg\"",
       .help = "Angle by which the camera turns from the azimuth that it has when this entry begins. Use `turn` "
               "instead of `azimuth`.",
       .put = intoEntry([](TimelineDraft& e) { return &e.turn; })},
      {.path = "timeline[].camera.elevation",
       .dimension = kAngle,
       .range = kMoveElevation,
       .example = "\"60 deg\"",
       .help = "Angle above the horizontal to which the camera goes.",
       .put = intoEntry([](TimelineDraft& e) { return &e.elevation; })},
      {.path = "timeline[].camera.zoom",
       .range = kMoveZoom,
       .example = "1.6",
       .help = "Magnification to which the camera zooms. At 1, the picture frames the whole motion, seen from the "
               "camera's new place.",
       .put = intoEntry([](TimelineDraft& e) { return &e.zoom; })},
  };
}

}  // namespace

std::vector<Key> timelineKeys() { return joined({whenKeys(), whatKeys(), paceKeys(), cameraMoveKeys()}); }

}  // namespace poinsot::scene
