// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/draw_list.h"

namespace poinsot::render {

/// A box as the mesh that it is: twelve triangles, all edges sharp. All boxes share one surface. A box without
/// volume has none.
draw::Mesh boxMesh(const draw::Box& box);

}  // namespace poinsot::render
