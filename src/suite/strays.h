// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "suite/suite.h"

namespace poinsot::suite {

compare::Outcome unmatchedOutcome(const GoldenCase& pattern);

/// Returns an outcome for each file among the references that no case is compared with.
/// @param only     names of the requested tests; empty for all. If not empty, the search covers only the folders
///   and patterns of these tests.
/// @param allMade  whether every case had a picture; otherwise, a stray file may belong to a case without one
std::vector<compare::Outcome> strayOutcomes(const GoldenManifest& manifest, const std::vector<GoldenCase>& cases,
                                            const std::vector<std::string>& only, bool allMade);

/// Finds references that no test uses and patterns that match no image, without drawing or comparing any picture.
std::vector<compare::Outcome> unusedReferences(const GoldenManifest& manifest);

}  // namespace poinsot::suite
