// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "draw/draw_list.h"

namespace poinsot::stage {

/// Adds an arrow: a round shaft and a cone whose proportions stay the same unless the arrow is shorter than four
/// thirds of its head, when the whole of it shrinks.
void addArrow(draw::DrawList& list, const Eigen::Vector3d& from_V, const Eigen::Vector3d& to_V, double shaftRadius,
              const draw::Color& color);

}  // namespace poinsot::stage
