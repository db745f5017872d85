// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace poinsot::draw {

/// Linear-light red, green, blue in [0, 1].
using Color = glm::vec3;

/// Linear light of one 8-bit sRGB value (IEC 61966-2-1).
float linearFromSrgb8(std::uint8_t value);

/// Nearest 8-bit sRGB value of a linear light, clamped to [0, 1].
std::uint8_t srgb8FromLinear(float linear);

/// Linear light of an sRGB colour written 0xRRGGBB.
Color fromSrgb(std::uint32_t hex);

}  // namespace poinsot::draw
