// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compare/film_diff.h"
#include "compare/outcome.h"
#include "compare/picture_diff.h"

namespace poinsot::compare {

/// For people: the verdict, and why, in the first line; then the figures.
std::string diffText(const PictureDiff& diff, const DiffRequest& request);
/// @param links  to folders, which were not followed
std::string diffText(const std::vector<Outcome>& outcomes, const std::vector<std::string>& links);
std::string diffText(const FilmDiff& diff);

/// The figures of a pair as terms and what is to be said of each. @pre diff.mismatch is empty.
std::vector<std::pair<std::string, std::string>> termsOf(const PictureDiff& diff, double pixelsPerDegree);

/// "12 identical, 1 near, 2 different".
std::string countsText(const std::vector<PictureDiff>& pictures);

}  // namespace poinsot::compare
