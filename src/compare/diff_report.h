// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "compare/film_diff.h"
#include "compare/outcome_page.h"

namespace poinsot::compare {

/// Returns an HTML page for one pair. @param outcome  result of the same comparison as `compared`
std::string diffReport(const ComparedPictures& compared, const Outcome& outcome, const OutcomePageHead& head);

/// Returns an HTML page for two films: the curve over time and the worst non-identical frame of each twentieth of
/// the film. The worst frame of all is selected first.
/// @throws core::Error(kIo), or (kLimit), if the films cannot be read again
std::string diffReport(const FilmDiff& diff, const std::filesystem::path& reference,
                       const std::filesystem::path& test, const DiffRequest& request, OutcomePageHead head);

}  // namespace poinsot::compare
