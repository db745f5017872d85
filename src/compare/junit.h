// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "compare/outcome.h"
#include "output/file_kind.h"

namespace poinsot::compare {

output::FileKind junitKind();

/// Returns the outcomes as JUnit XML for continuous integration: an error for each picture that could not be made
/// or read, a failure for each other outcome that does not pass. Each has the reason, the paths of the pictures
/// and the command that approves them. Pictures are attached in the form that GitLab and Jenkins read,
/// [[ATTACHMENT|path]], the new one first.
std::string junitXml(const std::vector<Outcome>& outcomes, const OutcomeReport& report);

}  // namespace poinsot::compare
