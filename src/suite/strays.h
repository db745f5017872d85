// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "suite/suite.h"

namespace poinsot::suite {

compare::Outcome unmatchedOutcome(const GoldenCase& pattern);

/// Returns an outcome for each stray file: a file among the references with which no case is compared.
/// @param only  names of the requested tests; empty for all. If not empty, only the folders and patterns of these
///   tests are searched.
/// @param allMade  whether every case had a picture; if not, a stray file may belong to a case without a picture
std::vector<compare::Outcome> strayOutcomes(const GoldenManifest& manifest, const std::vector<GoldenCase>& cases,
                                            const std::vector<std::string>& only, bool allMade);

/// Returns the references that no test uses, and the patterns that match no image. Draws and compares no picture.
std::vector<compare::Outcome> unusedReferences(const GoldenManifest& manifest);

}  // namespace poinsot::suite
