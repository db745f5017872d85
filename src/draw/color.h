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

/// Returns the nearest 8-bit sRGB value of a linear light, clamped to [0, 1].
std::uint8_t srgb8FromLinear(float linear);

/// Returns the linear light of a 16-bit sRGB value. 257 times an 8-bit value is the same light.
float linearFromSrgb16(std::uint16_t value);
std::uint16_t srgb16FromLinear(float linear);

/// Converts 8-bit or 16-bit samples, depending on the type.
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

/// Returns the linear light of an sRGB colour written 0xRRGGBB.
Color fromSrgb(std::uint32_t hex);

}  // namespace poinsot::draw
