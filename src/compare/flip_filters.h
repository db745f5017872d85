// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "compare/kernel.h"

namespace poinsot::compare {

/// One part of a contrast sensitivity: `profile` along both directions. The profiles of a channel sum, with their
/// products over two dimensions, to 1.
struct SensitivityPart {
  Kernel profile;
  double weight = 1;
};

/// What the eye blurs at a distance (section 4.1.1 of the paper named in compare/flip.h), for Y, Cx and Cz: sums of
/// a √(π/b) exp(-π² d²/b), d in degrees, with a, b of Y: 1, 0.0047; Cx: 1, 0.0053; Cz: 34.1, 0.04 and 13.5, 0.025.
/// One radius for all three.
std::array<std::vector<SensitivityPart>, 3> contrastSensitivity(double pixelsPerDegree);

/// What the eye takes for features (section 4.2): a Gaussian of half of 0.082 degrees, and its first and second
/// derivatives, whose positive and negative weights sum to 1 and -1.
struct FeatureKernels {
  Kernel smooth, edge, point;
};
FeatureKernels featureKernels(double pixelsPerDegree);

/// The largest radius of all of them, in pixels: what is farther away from a pixel does not concern its error.
int flipRadius(double pixelsPerDegree);

}  // namespace poinsot::compare
