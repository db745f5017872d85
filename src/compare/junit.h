// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "compare/outcome.h"
#include "output/file_kind.h"

namespace poinsot::compare {

/// JUnit reports of this program.
output::FileKind junitKind();

/// The outcomes as JUnit XML, as continuous integration reads it: a failure for what does not pass, an error for
/// what has no picture. Each has the reason, the paths of its pictures and the command that approves it; pictures
/// are attachments in the form that GitLab and Jenkins read, [[ATTACHMENT|path]]: the new one first.
std::string junitXml(const std::vector<Outcome>& outcomes, const OutcomeReport& report);

}  // namespace poinsot::compare
