// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/abi.h"

namespace poinsot::scene {

/// What happens from a film time on. Angles in radians, times in seconds of film.
struct TimelineEntry {
  double at_s = 0;
  double over_s = 0.8;             ///< that the changes take
  std::vector<int> shown, hidden;  ///< indices into timelineThings()
  std::optional<double> speed;     ///< factor on the film's speed from there on
  double hold_s = 0;               ///< that the motion stands still, once it has come to rest
  std::optional<double> azimuth_rad, elevation_rad, zoom;  ///< of the camera, reached after over_s
  double turn_rad = 0;                                     ///< added to the azimuth instead
};

/// A line of words under the picture, from one film time to another.
struct Caption {
  double from_s = 0, to_s = 0;
  std::string text;  ///< the TeX subset of text/
};

/// How the picture changes while the film runs.
struct Timeline {
  std::vector<TimelineEntry> entries;  ///< by time
  std::vector<Caption> captions;       ///< by time; they do not overlap
};

/// What a timeline can show and hide: every drawn thing that has a show.NAME.visible, then the parts of a picture
/// that stand still, and labels.
const std::vector<std::string>& timelineThings();

}  // namespace poinsot::scene
