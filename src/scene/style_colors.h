// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/abi.h"

namespace poinsot::scene {

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
  kMark,
  kAxis,
  kSpaceCone,
  kBodyCone,
  kTorque,
  kVector,
  kSupport,
};
constexpr std::size_t kColorMeanings = 20;

/// Key of a colour in [style.colors], with the example and the help text of the reference.
struct ColorKey {
  std::string_view name, example, help;
};

/// Returns the keys of all colours in the order of ColorMeaning.
const std::array<ColorKey, kColorMeanings>& colorKeys();

/// Colours that a scene sets, as 0xRRGGBB in sRGB. The index is a ColorMeaning. A missing colour is the theme's.
using GivenColors = std::array<std::optional<std::uint32_t>, kColorMeanings>;

}  // namespace poinsot::scene
