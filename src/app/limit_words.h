// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "image/near_rule.h"

namespace poinsot::app {

/// The limits of a rule as they are written on a command line and in a golden.toml. Each is a range from 0, so
/// that an identical picture always passes: "0-2", "0-1e-3"; of pixels a number or a share, "0-20", "0-0.5%".
///
/// Each sets one limit of the rule.
/// @throws core::Error(kUsage) with `name` and the word, saying how it is written.
void setMaxDifference(image::NearRule& rule, std::string_view name, std::string_view word);
void setDifferingPixels(image::NearRule& rule, std::string_view name, std::string_view word);
void setFlipMean(image::NearRule& rule, std::string_view name, std::string_view word);
void setFlipMax(image::NearRule& rule, std::string_view name, std::string_view word);

}  // namespace poinsot::app
