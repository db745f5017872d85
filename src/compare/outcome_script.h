// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/outcome.h"
#include "output/file_kind.h"

namespace poinsot::compare {

output::FileKind outcomeScriptKind();

/// Returns the outcome of a run as a JavaScript call of poinsotOutcome(). An index page of several runs loads such
/// scripts, because a page from the file system may load scripts but no data. The function's argument is an
/// object: verdict ("identical", "near" or that of the first failure), passed, counts, message (the first
/// failure's reason), page (path of the report relative to the script's folder, or null), finished (time in UTC).
/// @param script  path at which the text will be saved
std::string outcomeScript(const std::vector<Outcome>& outcomes, const OutcomeReport& report,
                          const std::filesystem::path& script);

/// Returns the script of a run that has not finished, or failed before comparing anything.
std::string brokenOutcomeScript(const std::string& message);

}  // namespace poinsot::compare
