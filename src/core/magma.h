// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace poinsot::core {

/// The colour map "magma": even to the eye, in grey and for every eye, from black over red to pale yellow. sRGB of
/// its entry `index`, 0 to 255.
std::array<std::uint8_t, 3> magma(std::size_t index);

}  // namespace poinsot::core
