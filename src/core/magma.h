// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace poinsot::core {

/// Returns a colour of the colour map "magma" (sRGB), from black over red to pale yellow. Equal steps of the index
/// look equal, even in grey and to colour-blind viewers.
/// @param index  0 to 255
std::array<std::uint8_t, 3> magma(std::size_t index);

}  // namespace poinsot::core
