// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "compare/outcome.h"
#include "output/file_kind.h"

namespace poinsot::compare {

/// A file that a table of outcomes may be added to: NAME.md, or the one that GITHUB_STEP_SUMMARY names.
const output::FileKind& markdownKind();

/// The outcomes in GitHub's Markdown, for the summary of a job: the counts, a table of what does not pass (fifty
/// at most), the command that approves it and the page with the pictures.
std::string markdownOf(const std::vector<Outcome>& outcomes, const OutcomeReport& report);

}  // namespace poinsot::compare
