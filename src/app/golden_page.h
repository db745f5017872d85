// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/golden_suite.h"

namespace poinsot::app {

/// The outcomes as one page of HTML that needs nothing else: pictures, style and script are in it, and it loads
/// nothing. A table that can be sorted; of each test the approved and the new picture side by side, under a slider
/// and blinking, their difference and FLIP's map. Of identical ones there is one picture.
/// @throws core::Error(kIo) if a picture cannot be read.
std::string goldenPage(const std::string& suite, const std::vector<GoldenOutcome>& outcomes, bool exact);

}  // namespace poinsot::app
