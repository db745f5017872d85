// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/draw_list.h"
#include "render/screen_mesh.h"

namespace poinsot::render {

/// The sharp edges that look at the eye as lines, moved a little towards it, so that the faces beside them do not
/// hide them: none when the mesh's edge_px is 0.
std::vector<draw::Curve> meshEdgeLines(const draw::Camera& camera, const ScreenMesh& screen);

}  // namespace poinsot::render
