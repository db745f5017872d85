// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/draw_list.h"
#include "render/screen_mesh.h"

namespace poinsot::render {

/// Returns the visible sharp edges of a mesh as lines. The lines are moved slightly towards the eye, so that the
/// faces beside them do not hide them. Returns no lines if the mesh's edge_px is 0.
std::vector<draw::Curve> meshEdgeLines(const draw::Camera& camera, const ScreenMesh& screen);

}  // namespace poinsot::render
