// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/camera.h"
#include "draw/draw_list.h"

namespace poinsot::render {

/// Returns a ball of glass above a plane, seen from 10 away.
inline draw::DrawList glassOverPlane(glm::ivec2 size_px, float radius) {
  draw::DrawList list;
  list.camera = draw::lookAt({9, 2, 4}, glm::vec3(0), {0, 0, 1}, 1.0f, size_px);
  list.camera.tanHalfFovY = 0.15f;
  list.camera.near = 5;
  list.camera.far = 15;
  draw::GlassEllipsoid glass;
  glass.semiAxes_V = glm::mat3(radius);
  list.glassEllipsoids = {glass};
  draw::GridPlane plane;
  plane.centre_V = {0, 0, -0.6f};
  plane.u_V = {1, 0, 0};
  plane.v_V = {0, 1.1f, 0};
  list.planes = {plane};
  return list;
}

}  // namespace poinsot::render
