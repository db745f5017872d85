// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace poinsot::render {

/// Area of the convex hull of points (Andrew's monotone chain): the outline of a convex solid, from its points
/// alone.
double hullArea(std::vector<glm::vec2> points);

}  // namespace poinsot::render
