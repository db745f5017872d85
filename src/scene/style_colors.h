// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/abi.h"

namespace poinsot::scene {

/// What a colour stands for in a picture.
enum class ColorMeaning {
  kPaper,
  kInk,
  kQuietInk,
  kL,
  kPlane,
  kOmega,
  kPolhode,
  kHerpolhode,
  kEllipsoid,
  kGraticule,
  kOmegaParts,
  kSeparatrix,
  kBody,
  kAxis,
  kSpaceCone,
  kBodyCone,
  kTorque,
  kVector,
  kSupport,
};
constexpr std::size_t kColorMeanings = 19;

/// Its key in [style.colors], with an example and what the reference says.
struct ColorKey {
  std::string_view name, example, help;
};

/// In the order of the enumerators.
const std::array<ColorKey, kColorMeanings>& colorKeys();

/// Colours that a scene gives, 0xRRGGBB in sRGB, by meaning; the others are the theme's.
using GivenColors = std::array<std::optional<std::uint32_t>, kColorMeanings>;

}  // namespace poinsot::scene
