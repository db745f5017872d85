// SPDX-License-Identifier: Apache-2.0
#include "stage/plot_tones.h"

#include <algorithm>
#include <glm/common.hpp>

namespace poinsot::stage {
namespace {

// Towards ink and towards paper, in linear light: farther, the hue or the type's contrast would be lost.
constexpr float kDarkest = 0.75f, kLightest = 0.16f;

/// `place` from 0, the darkest, to 1. Nothing is darker than ink.
draw::Color tone(const Palette& colors, const draw::Color& color, float place) {
  if (color == colors.ink) return glm::mix(color, colors.paper, kLightest * place);
  if (place < 0.5f) return glm::mix(color, colors.ink, kDarkest * (1 - 2 * place));
  return glm::mix(color, colors.paper, kLightest * (2 * place - 1));
}

}  // namespace

draw::Color familyColor(const Palette& colors, scene::QuantityFamily family) {
  switch (family) {
    case scene::QuantityFamily::kOmega:
      return colors.omega;
    case scene::QuantityFamily::kL:
      return colors.L;
    case scene::QuantityFamily::kBody:
      return colors.axis;
    case scene::QuantityFamily::kFlight:
      return colors.vector;
    case scene::QuantityFamily::kTime:
    case scene::QuantityFamily::kEnergy:
      break;
  }
  return colors.ink;
}

std::vector<draw::Color> quantityColors(const Palette& colors, const std::vector<int>& quantities) {
  const auto familyOf = [](int q) { return scene::stateQuantity(q).family; };
  std::vector<draw::Color> all;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const auto alike = [&](int q) { return familyOf(q) == familyOf(quantities[i]); };
    const auto first = quantities.begin(), here = first + static_cast<std::ptrdiff_t>(i);
    const auto place = static_cast<float>(std::count_if(first, here, alike));
    const auto others = static_cast<float>(std::count_if(first, quantities.end(), alike) - 1);
    const draw::Color color = familyColor(colors, familyOf(quantities[i]));
    all.push_back(others > 0 ? tone(colors, color, place / others) : color);
  }
  return all;
}

}  // namespace poinsot::stage
