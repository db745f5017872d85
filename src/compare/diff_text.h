// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compare/film_diff.h"
#include "compare/outcome.h"
#include "compare/picture_diff.h"

namespace poinsot::compare {

/// Returns the result of a comparison as text for people: first the verdict and its reason, then the figures.
std::string diffText(const PictureDiff& diff, const DiffRequest& request);
/// Returns the results of many comparisons as text for people.
/// @param links  links to folders, which were not followed
std::string diffText(const std::vector<Outcome>& outcomes, const std::vector<std::string>& links);
std::string diffText(const FilmDiff& diff);

/// Returns the figures of a comparison as pairs of label and value. @pre diff.mismatch is empty.
std::vector<std::pair<std::string, std::string>> termsOf(const PictureDiff& diff, double pixelsPerDegree);

/// Returns the number of pictures of each verdict: "12 identical, 1 near, 2 different".
std::string countsText(const std::vector<PictureDiff>& pictures);

}  // namespace poinsot::compare
