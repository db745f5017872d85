// SPDX-License-Identifier: Apache-2.0
#include "stage/plot/plot_tones.h"

#include <algorithm>
#include <glm/common.hpp>

namespace poinsot::stage {
namespace {

// Largest fractions of ink and of paper in a tone, mixed in linear light. Larger fractions would lose the hue, or
// the contrast that text needs. On dark paper, a visible step needs a larger fraction.
constexpr float kToInk = 0.75f, kToLightPaper = 0.16f, kToDarkPaper = 0.42f;
constexpr float kLeastContrast = 4.5f;  // smallest contrast of text

float luminance(const draw::Color& c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; }

float shareOfPaper(const draw::Color& color, const draw::Color& paper) {
  const float there = luminance(paper), here = luminance(color);
  if (there > here) return kToLightPaper;
  constexpr float kFlare = 0.05f;  // glare constant of WCAG 2's contrast ratio
  const float faintest = kLeastContrast * (there + kFlare) - kFlare;
  return std::clamp((here - faintest) / (here - there), kToLightPaper, kToDarkPaper);
}

/// Returns a tone of a colour. Ink has no stronger tone than itself.
/// @param place  0 for the strongest tone, 1 for the faintest
draw::Color tone(const Palette& colors, const draw::Color& color, float place) {
  const float share = shareOfPaper(color, colors.paper);
  if (color == colors.ink) return glm::mix(color, colors.paper, share * place);
  if (place < 0.5f) return glm::mix(color, colors.ink, kToInk * (1 - 2 * place));
  return glm::mix(color, colors.paper, share * (2 * place - 1));
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
