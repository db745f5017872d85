// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/abi.h"

namespace poinsot::scene {

/// Moment that a timeline entry names.
struct Moment {
  enum class Kind {
    kFilm,    ///< film time
    kMotion,  ///< motion time
    kEvent,   ///< event of the motion
  };
  Kind kind = Kind::kFilm;
  double t_s = 0;         ///< film time or motion time
  int event = 0;          ///< index into eventKinds()
  int number = 1;         ///< number of the event among the events of its kind in the film, from 1
  bool isMiddle = false;  ///< whether the moment is the middle of the slow motion or pause, not the begin
};

/// Changes that begin at one film time. Angles are in radians, times in seconds of film.
struct TimelineEntry {
  std::size_t place = 0;  ///< index in the scene file
  Moment moment;
  double at_s = 0;                   ///< film time at which the changes begin, from placeTimeline()
  double over_s = 0.8;               ///< duration of each change
  std::vector<int> shown, hidden;    ///< things to show and to hide, as indices into timelineThings()
  std::optional<double> speed;       ///< new factor on the film's speed, until a later entry changes it
  std::optional<double> speedFor_s;  ///< duration of `speed`, after which the speed before this entry returns
  double hold_s = 0;                 ///< duration of a pause, after the motion has come to rest
  std::optional<double> azimuth_rad, elevation_rad, zoom;  ///< new values of the camera, reached after over_s
  double turn_rad = 0;                                     ///< angle to add to the azimuth, instead of azimuth_rad
  std::optional<std::string> caption;  ///< text that replaces the caption before; empty for no caption
  std::optional<double> captionFor_s;  ///< duration of the caption

  bool changesSpeed() const { return speed.has_value() || hold_s > 0; }
  /// Returns the duration of the slow motion or pause, without its soft begin and end.
  double lasting_s() const { return hold_s > 0 ? hold_s : speedFor_s.value_or(0); }
};

/// Line of text under the picture, shown from film time from_s to to_s.
struct Caption {
  double from_s = 0, to_s = 0;
  std::string text;  ///< text in the TeX subset of the text library
};

struct Timeline {
  std::vector<TimelineEntry> entries;  ///< entries, sorted by time
  std::vector<Caption> captions;       ///< captions, sorted by time, without overlaps
};

/// Returns the names of all things that a timeline can show and hide: first the things with a key
/// show.NAME.visible, then parts such as the title, and the labels.
const std::vector<std::string>& timelineThings();

}  // namespace poinsot::scene
