// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scene/scene.h"
#include "stage/body/figure.h"

/// The parts of a body as a figure.
namespace poinsot::stage {

/// What the scene shows in place of the body, else what the body is made of; none for bare moments.
std::vector<scene::Part> partsToShow(const scene::Scene& scene);

/// The point of B that stands at the origin: the fixed point; of parts shown in place of the body, their own
/// centre of mass where the body turns about its centre of mass.
Eigen::Vector3d originOfFigure(const scene::Scene& scene, const std::vector<scene::Part>& shown);

/// The parts about `origin_B`; point masses are balls, joined to the centre of mass by rods.
Figure partsFigure(const std::vector<scene::Part>& parts, const Eigen::Vector3d& origin_B);

}  // namespace poinsot::stage
