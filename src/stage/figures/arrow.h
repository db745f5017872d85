// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "draw/draw_list.h"

namespace poinsot::stage {

/// Adds an arrow: a round shaft and a cone as its head, in a fixed proportion. If the arrow is too short for its
/// head, head and shaft are both scaled down.
void addArrow(draw::DrawList& list, const Eigen::Vector3d& from_V, const Eigen::Vector3d& to_V, double shaftRadius,
              const draw::Color& color);

/// Returns the radius of the head of an arrow that is long enough for its head.
double headRadius(double shaftRadius);

}  // namespace poinsot::stage
