// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/outcome.h"

namespace poinsot::app {

/// The outcomes in GitHub's Markdown, for the summary of a job: the counts, a table of what does not pass (fifty
/// at most), the command that approves it and the page with the pictures.
std::string markdownOf(const std::vector<Outcome>& outcomes, const OutcomeReport& report);

}  // namespace poinsot::app
