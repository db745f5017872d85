// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/outcome.h"
#include "output/file_kind.h"

namespace poinsot::compare {

output::FileKind outcomeScriptKind();

/// Returns the outcome of a run as JavaScript: a call of poinsotOutcome(). An index page of several runs loads
/// these scripts, because a page from the file system may load scripts but no data.
/// The function's argument is an object. Its fields are verdict ("identical", "near" or the verdict of the first
/// failure), passed, counts, message (the reason of the first failure), page (the report's path relative to the
/// script's folder, or null) and finished (time in UTC).
/// @param script  path at which the text will be saved
std::string outcomeScript(const std::vector<Outcome>& outcomes, const OutcomeReport& report,
                          const std::filesystem::path& script);

/// Returns the script of a run that is not finished, or that failed before it compared anything.
std::string brokenOutcomeScript(const std::string& message);

}  // namespace poinsot::compare
