// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "compare/kernel.h"

namespace poinsot::compare {

/// Colours as FLIP sees them. All numbers are of the paper named in compare/flip.h, sections 4.1 and 3.
using Triple = std::array<double, 3>;

/// Linear light of an sRGB value in [0, 1] (IEC 61966-2-1).
double linearLight(double encoded);

/// The linear opponent space Y Cx Cz of linear RGB: lightness -16 to 100, red-green, yellow-blue.
Triple opponentColor(const Triple& rgb);

/// The linear RGB of an opponent colour, each channel cut to [0, 1].
Triple rgbOfOpponent(const Triple& yCxCz);

/// CIELab (D65) of linear RGB, whose a and b shrink in the dark (Hunt effect).
Triple huntLab(const Triple& rgb);

/// HyAB distance of two colours in Lab: |ΔL| + √(Δa² + Δb²).
double hyabDistance(const Triple& a, const Triple& b);

/// HyAB to the power 0.7 of green and blue, the largest there is: 41.276098.
double largestColorDistance();

/// The distance of two Hunt-adjusted colours as an error in [0, 1]: 0.95 of the range for the lower 0.4 of
/// distances^0.7, where the eye tells more apart.
double colorError(const Triple& a, const Triple& b);

/// One part of a contrast sensitivity: `profile` along both directions. The profiles of a channel sum, with their
/// products over two dimensions, to 1.
struct SensitivityPart {
  Kernel profile;
  double weight = 1;
};

/// Filters that blur as the eye does at a distance (section 4.1.1 of the paper named in compare/flip.h), for Y, Cx
/// and Cz: sums of a √(π/b) exp(-π² d²/b), d in degrees, with a, b of Y: 1, 0.0047; Cx: 1, 0.0053; Cz: 34.1, 0.04
/// and 13.5, 0.025. One radius for all three.
std::array<std::vector<SensitivityPart>, 3> contrastSensitivity(double pixelsPerDegree);

/// Filters for what the eye takes for features (section 4.2): a Gaussian of half of 0.082 degrees, and its first
/// and second derivatives, whose positive and negative weights sum to 1 and -1.
struct FeatureKernels {
  Kernel smooth, edge, point;
};
FeatureKernels featureKernels(double pixelsPerDegree);

/// The largest radius of all of them, in pixels: what is farther away from a pixel does not concern its error.
int flipRadius(double pixelsPerDegree);

}  // namespace poinsot::compare
