// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "picture_source.h"

namespace poinsot::python {

/// Arguments of poinsot.diff() that decide how pictures are compared.
struct DiffAsk {
  RuleWords rule;
  std::vector<std::vector<double>> ignore;  ///< boxes: left, top, width, height; pixels
  PictureSource mask;                       ///< None if there is no mask
  double pixelsPerDegree = 0;
  int jobs = 1;                     ///< frames of films compared at a time
  std::vector<std::string> limits;  ///< words of --limit
};

/// Compares two pictures or two films, and returns the JSON that `diff --json` prints.
/// @throws core::Error(kUsage) for an unknown rule, for pictures of different sizes, and for a film beside a
/// picture; otherwise as compare::compareFiles() and compare::diffFilms().
std::string diffJson(const PictureSource& reference, const PictureSource& test, const DiffAsk& ask);

}  // namespace poinsot::python
