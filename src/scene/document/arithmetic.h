// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace poinsot::scene {

/// Returns the value of a product or quotient of numbers and pi, such as "2*pi", "-np.pi/6" and "1/4". Empty for
/// other texts, and for a single number.
std::optional<double> arithmeticIn(std::string_view text);

}  // namespace poinsot::scene
