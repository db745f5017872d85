// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/abi.h"

namespace poinsot::scene {

/// Changes at a film time. Angles in radians, times in seconds of film.
struct TimelineEntry {
  double at_s = 0;
  double over_s = 0.8;                                     ///< duration of the changes
  std::vector<int> shown, hidden;                          ///< indices into timelineThings()
  std::optional<double> speed;                             ///< factor on the film's speed from then on
  double hold_s = 0;                                       ///< pause of the motion, once it has come to rest
  std::optional<double> azimuth_rad, elevation_rad, zoom;  ///< camera targets, reached after over_s
  double turn_rad = 0;                                     ///< added to the azimuth, instead of azimuth_rad
};

/// Line of text under the picture, from one film time to another.
struct Caption {
  double from_s = 0, to_s = 0;
  std::string text;  ///< in the TeX subset of the text library
};

struct Timeline {
  std::vector<TimelineEntry> entries;  ///< sorted by time
  std::vector<Caption> captions;       ///< sorted by time, without overlaps
};

/// Returns the names of everything that a timeline can show and hide: things with a key show.NAME.visible, then
/// the static parts of a picture and the labels.
const std::vector<std::string>& timelineThings();

}  // namespace poinsot::scene
