// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "compare/kernel.h"

namespace poinsot::compare {

/// Term of a contrast sensitivity: a 2D filter with `profile` along both axes, times `weight`. The terms of a
/// channel sum to 1.
struct SensitivityPart {
  Kernel profile;
  double weight = 1;
};

/// Returns the filters that blur a picture as the eye does at a distance, for Y, Cx and Cz (section 4.1.1 of the
/// paper cited in compare/flip.h). Each filter is a sum of terms a √(π/b) exp(-π² d²/b), with d in degrees.
/// Values of (a, b): for Y (1, 0.0047); for Cx (1, 0.0053); for Cz (34.1, 0.04) and (13.5, 0.025). All three
/// filters have the same radius.
std::array<std::vector<SensitivityPart>, 3> contrastSensitivity(double pixelsPerDegree);

/// Filters that detect features (section 4.2 of the paper). `smooth` is a Gaussian with a standard deviation of
/// 0.041 degrees, half of 0.082. `edge` and `point` are its first and second derivatives. Their positive weights
/// sum to 1, their negative weights to -1.
struct FeatureKernels {
  Kernel smooth, edge, point;
};
FeatureKernels featureKernels(double pixelsPerDegree);

/// Returns the largest radius of all filters, in pixels. A pixel's error does not depend on pixels farther away.
int flipRadius(double pixelsPerDegree);

}  // namespace poinsot::compare
