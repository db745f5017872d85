// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "geometry/mesh.h"

namespace poinsot::stage {

/// Returns a box with walls of thickness `wall`. A window in the face at +z shows the cavity.
/// @pre 0 < 2 wall < each edge.
geometry::Mesh hollowBoxMesh(const Eigen::Vector3d& edges, double wall);

}  // namespace poinsot::stage
