// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/golden_suite.h"

namespace poinsot::app {

/// What the page of a suite says besides its outcomes.
struct GoldenPageRequest {
  std::filesystem::path manifest;
  std::filesystem::path page;  ///< file that it is written to
  std::string approve;         ///< command that approves the tests whose names follow
  bool exact = false;          ///< only identical pictures pass
};

/// Returns the outcomes as a page (diff_page.h): the approved and the new picture of each test, one of identical
/// ones. A picture that cannot be read is left out.
std::string goldenPage(const std::vector<GoldenOutcome>& outcomes, const GoldenPageRequest& request);

}  // namespace poinsot::app
