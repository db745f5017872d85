// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/golden_suite.h"

namespace poinsot::app {

/// The outcomes as a page (diff_page.h): of each test the approved and the new picture; of identical ones there is
/// one.
/// @throws core::Error(kIo) if a picture cannot be read.
std::string goldenPage(const std::string& suite, const std::vector<GoldenOutcome>& outcomes, bool exact);

}  // namespace poinsot::app
