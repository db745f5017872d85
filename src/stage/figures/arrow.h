// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "draw/draw_list.h"

namespace poinsot::stage {

/// Adds an arrow: a round shaft and a cone in fixed proportion. An arrow that is too short for its head shrinks as
/// a whole.
void addArrow(draw::DrawList& list, const Eigen::Vector3d& from_V, const Eigen::Vector3d& to_V, double shaftRadius,
              const draw::Color& color);

/// Returns the radius of an arrow's head, unless the arrow is too short for the head.
double headRadius(double shaftRadius);

}  // namespace poinsot::stage
