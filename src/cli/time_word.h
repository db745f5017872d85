// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace poinsot::cli {

/// A number of seconds, or a number with a unit of time as scene files have it; possibly not finite.
/// @throws core::Error(kUsage) naming the option
double parseTime_s(std::string_view option, const std::string& word);

/// "0,-1.5,90 ms", separated by commas.
/// @throws core::Error(kUsage) naming the option
std::vector<double> parseTimes_s(std::string_view option, std::string_view words);

}  // namespace poinsot::cli
