// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/outcome.h"
#include "output/file_kind.h"

namespace poinsot::compare {

/// Outcome scripts of this program.
output::FileKind outcomeScriptKind();

/// The outcome of a run as one call in JavaScript. A page that is read from the file system may load scripts but
/// no data, so an index page of several runs loads this and defines the function poinsotOutcome(), which takes an
/// object: verdict ("identical", "near" or that of the first failure), passed, counts, message (the first
/// failure's reason), page (path of the report from the script's folder, or null), finished (time in UTC).
/// @param script  where the text is going to be
std::string outcomeScript(const std::vector<Outcome>& outcomes, const OutcomeReport& report,
                          const std::filesystem::path& script);

/// The same of a run that has not finished, or has failed before it compared anything.
std::string brokenOutcomeScript(const std::string& message);

}  // namespace poinsot::compare
