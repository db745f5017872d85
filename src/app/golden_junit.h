// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/golden_suite.h"

namespace poinsot::app {

/// The outcomes as JUnit XML, as continuous integration reads it: a failure for what does not pass, an error for
/// what has no picture.
std::string junitXml(const std::string& suite, const std::vector<GoldenOutcome>& outcomes, bool exact);

}  // namespace poinsot::app
