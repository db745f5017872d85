// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "draw/visibility_solids.h"

namespace poinsot::draw {

/// Null where the mesh is empty or not wholly in front of the camera.
std::unique_ptr<const Occluder> makeMeshOccluder(const Camera& camera, const Mesh& mesh);

}  // namespace poinsot::draw
