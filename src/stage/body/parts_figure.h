// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scene/scene.h"
#include "stage/body/figure.h"

namespace poinsot::stage {

/// Returns the parts to draw: those that the scene shows instead of the body, or else the body's own parts. The
/// result is empty if the scene gives only the moments of the body.
std::vector<scene::Part> partsToShow(const scene::Scene& scene);

/// Returns the point that is drawn at the origin, in axes B: the fixed point of the body. If the scene shows other
/// parts instead of the body, and the body rotates about its centre of mass, returns the centre of mass of these
/// parts.
Eigen::Vector3d originOfFigure(const scene::Scene& scene, const std::vector<scene::Part>& shown);

/// Returns a figure of the parts, with `origin_B` as origin. Point masses are drawn as balls, joined to the centre
/// of mass by rods.
Figure partsFigure(const std::vector<scene::Part>& parts, const Eigen::Vector3d& origin_B);

}  // namespace poinsot::stage
