// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/abi.h"

namespace poinsot::request {

/// Largest number of films in a series.
inline constexpr int kMostFilms = 10'000;

/// One film of a series: overrides without ranges, and the name of the output.
struct SeriesFilm {
  std::vector<std::string> overrides;
  std::string output;
};

/// Returns whether the name of an output has a place for a value, that is, whether it is meant for a series.
bool isSeriesName(const std::string& name);

/// Returns the films of a series: one for each combination of values of the ranges in `overrides`. The first range
/// varies fastest.
/// @param name  name of the outputs. {KEY} stands for the value of that key, a number without a unit; {value} is
///   allowed instead if there is only one range
/// @throws core::Error(kUsage) for a malformed range, no range, a range that is missing in the name, two films
/// with the same name, or more than kMostFilms films.
std::vector<SeriesFilm> seriesOf(const std::vector<std::string>& overrides, const std::string& name);

}  // namespace poinsot::request
