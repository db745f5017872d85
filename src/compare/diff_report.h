// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "compare/film_diff.h"
#include "compare/outcome_page.h"

namespace poinsot::compare {

/// Shows one pair that was just compared. `outcome` is made of the same comparison.
std::string diffReport(const ComparedPictures& compared, const Outcome& outcome, const OutcomePageHead& head);

/// Shows the curve of two films over time and, of each twentieth of the film, the worst frame that is not
/// identical; the worst of all is chosen first.
/// @throws core::Error(kIo), or (kLimit), if the films cannot be read again.
std::string diffReport(const FilmDiff& diff, const std::filesystem::path& reference,
                       const std::filesystem::path& test, const DiffRequest& request, OutcomePageHead head);

}  // namespace poinsot::compare
