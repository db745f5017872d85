// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "suite/suite.h"

namespace poinsot::suite {

/// The error of a pattern of images that matches no file.
compare::Outcome unmatchedOutcome(const GoldenCase& pattern);

/// Files among the references that are compared with nothing.
/// @param only     names of the tests that were asked for; empty for all. If some were, only files beside their
///                 references are looked at, and those that a pattern among them would make.
/// @param allMade  whether every case had a picture; else a stray file may belong to one that had none
std::vector<compare::Outcome> strayOutcomes(const GoldenManifest& manifest, const std::vector<GoldenCase>& cases,
                                            const std::vector<std::string>& only, bool allMade);

/// Files among the references that no test makes, found without making or comparing any picture; and the errors of
/// patterns that match no image.
std::vector<compare::Outcome> unusedReferences(const GoldenManifest& manifest);

}  // namespace poinsot::suite
