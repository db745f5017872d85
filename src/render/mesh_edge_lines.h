// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/draw_list.h"
#include "render/screen_mesh.h"

namespace poinsot::render {

/// Returns the sharp edges that face the eye as lines, moved slightly towards the eye so that the adjacent faces
/// do not hide them. Empty if the mesh's edge_px is 0.
std::vector<draw::Curve> meshEdgeLines(const draw::Camera& camera, const ScreenMesh& screen);

}  // namespace poinsot::render
