// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "compare/kernel.h"

namespace poinsot::compare {

/// Colour with three components, in any space. All constants of this file are from sections 3 and 4.1 of the paper
/// named in compare/flip.h.
using Triple = std::array<double, 3>;

/// Returns the linear light of an sRGB value in [0, 1] (IEC 61966-2-1).
double linearLight(double encoded);

/// Converts linear RGB to the linear opponent space Y Cx Cz: lightness -16 to 100, red-green, yellow-blue.
Triple opponentColor(const Triple& rgb);

/// Converts an opponent colour to linear RGB, with each channel clipped to [0, 1].
Triple rgbOfOpponent(const Triple& yCxCz);

/// Converts linear RGB to CIELab (D65) with the Hunt effect: a and b shrink in the dark.
Triple huntLab(const Triple& rgb);

/// Returns the HyAB distance of two Lab colours: |ΔL| + √(Δa² + Δb²).
double hyabDistance(const Triple& a, const Triple& b);

/// Returns the largest colour distance, between green and blue: HyAB to the power 0.7, 41.276098.
double largestColorDistance();

/// Returns the distance of two Hunt-adjusted colours as an error in [0, 1]. The lower 0.4 of distances^0.7, where
/// the eye distinguishes more, gets 0.95 of the range.
double colorError(const Triple& a, const Triple& b);

/// One term of a contrast sensitivity: `profile` in both directions, times `weight`. The 2D kernel of a channel
/// sums to 1.
struct SensitivityPart {
  Kernel profile;
  double weight = 1;
};

/// Returns the filters that blur as the eye does at a distance, for Y, Cx and Cz (section 4.1.1 of the paper named
/// in compare/flip.h). They are sums of a √(π/b) exp(-π² d²/b), d in degrees, with a, b of Y: 1, 0.0047; Cx: 1,
/// 0.0053; Cz: 34.1, 0.04 and 13.5, 0.025. All three have one radius.
std::array<std::vector<SensitivityPart>, 3> contrastSensitivity(double pixelsPerDegree);

/// Filters that detect features (section 4.2): a Gaussian with a standard deviation of half of 0.082 degrees, and
/// its first and second derivatives, whose positive and negative weights sum to 1 and -1.
struct FeatureKernels {
  Kernel smooth, edge, point;
};
FeatureKernels featureKernels(double pixelsPerDegree);

/// Returns the largest radius of all filters in pixels; a pixel's error does not depend on anything farther away.
int flipRadius(double pixelsPerDegree);

}  // namespace poinsot::compare
