// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "figure/visibility_solids.h"

namespace poinsot::figure {

/// Null where the mesh is empty or not wholly in front of the camera.
std::unique_ptr<const Occluder> makeMeshOccluder(const draw::Camera& camera, const draw::Mesh& mesh);

}  // namespace poinsot::figure
