// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "compare/outcome.h"
#include "output/file_kind.h"

namespace poinsot::compare {

/// Returns the kind of file to which a table of outcomes may be appended: a file NAME.md, or the file that the
/// environment variable GITHUB_STEP_SUMMARY names.
const output::FileKind& markdownKind();

/// Returns the outcomes in GitHub's Markdown, for the summary of a CI job. The text has the counts, a table of at
/// most fifty failures, the command that approves them, and the path of the page with the pictures.
std::string markdownOf(const std::vector<Outcome>& outcomes, const OutcomeReport& report);

}  // namespace poinsot::compare
