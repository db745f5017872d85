// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "compare/outcome.h"
#include "output/file_kind.h"

namespace poinsot::compare {

output::FileKind junitKind();

/// Returns the outcomes as JUnit XML for continuous integration. A picture that could not be made or read is an
/// error; any other outcome that does not pass is a failure. Errors and failures contain the reason, the paths of
/// the pictures, and the command that approves them. The pictures are attached as [[ATTACHMENT|path]], which
/// GitLab and Jenkins read, the new picture first.
std::string junitXml(const std::vector<Outcome>& outcomes, const OutcomeReport& report);

}  // namespace poinsot::compare
