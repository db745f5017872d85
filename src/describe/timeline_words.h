// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace poinsot::describe {

/// Timeline entry in words, for a list from which a user chooses a moment.
struct TimelineWords {
  double at_s = 0;     ///< film time at which the entry begins
  std::string moment;  ///< moment in the scene file, such as "flip 2"; empty if the file gives a film time
  std::string text;    ///< caption and changes, such as "“It flips.”; speed 0.2 for 3 s". UTF-8, no TeX
};

/// Describes all entries of the scene's timeline, sorted by film time.
std::vector<TimelineWords> timelineWords(const scene::Scene& scene);

}  // namespace poinsot::describe
