// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "draw/color.h"

/// Measures how far apart colours are, for normal and for colour-blind eyes. Reference of palette_test.cpp,
/// independent of the code under test.
namespace poinsot::stage {

enum class Sight { kNormal, kDeuteranopia, kProtanopia };

/// Returns a colour of linear light as an eye sees it, clamped to what a screen shows.
/// Source: Machado, Oliveira, Fernandes, "A Physiologically-based Model for Simulation of Color Vision
/// Deficiency", IEEE Trans. Vis. Comput. Graph. 15(6), 2009: the published matrices of severity 1.0, for linear
/// sRGB.
draw::Color simulated(const draw::Color& color, Sight sight);

/// CIELAB coordinates L*, a*, b*.
using Lab = std::array<double, 3>;

/// Returns the CIELAB 1976 coordinates of linear sRGB, with white point D65.
Lab lab(const draw::Color& color);

/// Returns the colour difference of CIE 1976, the distance in CIELAB.
double deltaE76(const Lab& a, const Lab& b);

/// Returns the colour difference CIEDE2000 with all weights 1.
/// Source: Sharma, Wu, Dalal, "The CIEDE2000 Color-Difference Formula: Implementation Notes, Supplementary Test
/// Data, and Mathematical Observations", Color Res. Appl. 30(1), 2005.
double deltaE2000(const Lab& a, const Lab& b);

/// Returns the relative luminance of linear sRGB; contrast() returns the contrast of two colours, 1 to 21.
/// Source: W3C, Web Content Accessibility Guidelines 2.1, "relative luminance" and "contrast ratio".
double luminance(const draw::Color& color);
double contrast(const draw::Color& a, const draw::Color& b);

}  // namespace poinsot::stage
