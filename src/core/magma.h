// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace poinsot::core {

/// Returns an entry of the colour map "magma", from black over red to pale yellow, as sRGB. Equal steps look
/// equal, also in grey and to colour-blind viewers.
/// @param index  0 to 255
std::array<std::uint8_t, 3> magma(std::size_t index);

}  // namespace poinsot::core
