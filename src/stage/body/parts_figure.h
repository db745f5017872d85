// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scene/scene.h"
#include "stage/body/figure.h"

namespace poinsot::stage {

/// Returns the parts that the scene shows instead of the body, or else the body's own; empty for bare moments.
std::vector<scene::Part> partsToShow(const scene::Scene& scene);

/// Returns the point of B that is drawn at the origin: the fixed point. Parts shown instead of the body have their
/// own centre of mass there, if the body turns about its centre of mass.
Eigen::Vector3d originOfFigure(const scene::Scene& scene, const std::vector<scene::Part>& shown);

/// Returns a figure of the parts about `origin_B`. Point masses are balls, joined to the centre of mass by rods.
Figure partsFigure(const std::vector<scene::Part>& parts, const Eigen::Vector3d& origin_B);

}  // namespace poinsot::stage
