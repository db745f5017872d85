// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "compare/kernel.h"

namespace poinsot::compare {

/// Colour with three components, in any colour space. All constants of this file are from sections 3 and 4.1 of
/// the paper cited in compare/flip.h.
using Triple = std::array<double, 3>;

/// Converts an sRGB value in [0, 1] to linear light (IEC 61966-2-1).
double linearLight(double encoded);

/// Converts linear RGB to the linear opponent space Y Cx Cz. Y is the lightness, from -16 to 100. Cx is red
/// against green, Cz is yellow against blue.
Triple opponentColor(const Triple& rgb);

/// Converts an opponent colour to linear RGB, with each channel clipped to [0, 1].
Triple rgbOfOpponent(const Triple& yCxCz);

/// Converts linear RGB to CIELab (D65), adjusted for the Hunt effect: a and b become smaller for dark colours.
Triple huntLab(const Triple& rgb);

/// Returns the HyAB distance of two Lab colours: |ΔL| + √(Δa² + Δb²).
double hyabDistance(const Triple& a, const Triple& b);

/// Returns the largest colour distance, 41.276098. It is the HyAB distance of green and blue, to the power 0.7.
double largestColorDistance();

/// Returns the difference of two Hunt-adjusted colours as an error in [0, 1]. It depends on d, the HyAB distance
/// to the power 0.7. The lower 0.4 of d's range has errors from 0 to 0.95, because the eye distinguishes more
/// there.
double colorError(const Triple& a, const Triple& b);

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
