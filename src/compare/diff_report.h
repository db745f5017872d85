// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "compare/film_diff.h"
#include "compare/outcome_page.h"

namespace poinsot::compare {

/// Returns an HTML page that shows the comparison of one pair.
/// @param outcome  result of the same comparison as `compared`
std::string diffReport(const ComparedPictures& compared, const Outcome& outcome, const OutcomePageHead& head);

/// Returns an HTML page that shows the comparison of two films. The page has the curve over time, and the worst
/// frame of each twentieth of the film unless that frame is identical. The worst frame of the film is selected
/// first.
/// @throws core::Error(kIo), or (kLimit), if the films cannot be read again
std::string diffReport(const FilmDiff& diff, const std::filesystem::path& reference,
                       const std::filesystem::path& test, const DiffRequest& request, OutcomePageHead head);

}  // namespace poinsot::compare
