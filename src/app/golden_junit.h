// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/golden_suite.h"

namespace poinsot::app {

/// How such a file begins: by this, one of an earlier run is known.
inline constexpr std::string_view kJunitMark =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- poinsot golden -->\n";

/// The outcomes as JUnit XML, as continuous integration reads it: a failure for what does not pass, an error for
/// what has no picture.
std::string junitXml(const std::string& suite, const std::vector<GoldenOutcome>& outcomes, bool exact);

}  // namespace poinsot::app
