// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace poinsot::render {

/// Returns the area of the convex hull of points, by Andrew's monotone chain. The outline of a convex solid
/// follows from its points alone.
double hullArea(std::vector<glm::vec2> points);

}  // namespace poinsot::render
