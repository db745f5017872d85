// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/abi.h"

namespace poinsot::scene {

/// Changes that begin at one film time. Angles are in radians, times in seconds of film.
struct TimelineEntry {
  double at_s = 0;
  double over_s = 0.8;             ///< duration of each change
  std::vector<int> shown, hidden;  ///< things to show and to hide, as indices into timelineThings()
  std::optional<double> speed;     ///< new factor on the film's speed, until a later entry changes it
  double hold_s = 0;               ///< duration of a pause, after the motion has come to rest
  std::optional<double> azimuth_rad, elevation_rad, zoom;  ///< new values of the camera, reached after over_s
  double turn_rad = 0;                                     ///< angle to add to the azimuth, instead of azimuth_rad
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
