// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <span>

namespace poinsot::stage {

/// The pixels that a metre of the body has at most in each of several panels, for it to be as large in all of
/// them. Infinite where they can have too different ones: bodies that could differ by more than 1.6 in size are
/// not drawn alike, as the smaller would look lost. @pre there is one.
inline double commonMetre_px(std::span<const double> possible_px) {
  constexpr double kMostUnlike = 1.6;
  const auto [least, most] = std::ranges::minmax(possible_px);
  return most <= kMostUnlike * least ? least : std::numeric_limits<double>::infinity();
}

}  // namespace poinsot::stage
