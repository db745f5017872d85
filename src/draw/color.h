// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <type_traits>

#include "draw/glm_layout.h"

namespace poinsot::draw {

/// Colour as linear-light red, green and blue in [0, 1].
using Color = glm::vec3;

/// Returns the linear light of an 8-bit sRGB value (IEC 61966-2-1).
float linearFromSrgb8(std::uint8_t value);

/// Returns the 8-bit sRGB value nearest to a linear light. Light outside [0, 1] is clamped.
std::uint8_t srgb8FromLinear(float linear);

/// Returns the linear light of a 16-bit sRGB value. The 16-bit value 257 v equals the 8-bit value v.
float linearFromSrgb16(std::uint16_t value);
std::uint16_t srgb16FromLinear(float linear);

/// Versions of these functions for 8-bit and 16-bit samples, selected by the type.
template <typename Sample>
float linearFromSrgb(Sample value) {
  static_assert(std::is_same_v<Sample, std::uint8_t> || std::is_same_v<Sample, std::uint16_t>);
  if constexpr (sizeof(Sample) == 1)
    return linearFromSrgb8(value);
  else
    return linearFromSrgb16(value);
}
template <typename Sample>
Sample srgbFromLinear(float linear) {
  static_assert(std::is_same_v<Sample, std::uint8_t> || std::is_same_v<Sample, std::uint16_t>);
  if constexpr (sizeof(Sample) == 1)
    return srgb8FromLinear(linear);
  else
    return srgb16FromLinear(linear);
}

/// Returns the linear light of an sRGB colour given as 0xRRGGBB.
Color fromSrgb(std::uint32_t hex);

}  // namespace poinsot::draw
