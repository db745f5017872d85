// SPDX-License-Identifier: Apache-2.0
#include "draw/camera.h"

#include <glm/geometric.hpp>

#include <cmath>

#include "core/expect.h"

namespace poinsot::draw {

Camera lookAt(glm::vec3 eye_V, glm::vec3 target_V, glm::vec3 up_V, float fovY_rad, glm::vec2 size_px) {
  POINSOT_EXPECT(eye_V != target_V);
  const glm::vec3 backward = glm::normalize(eye_V - target_V);
  const glm::vec3 right = glm::cross(up_V, backward);
  POINSOT_EXPECT(glm::length(right) > 1e-6f);
  Camera camera;
  camera.eye_V = eye_V;
  camera.R_VC[0] = glm::normalize(right);
  camera.R_VC[1] = glm::cross(backward, camera.R_VC[0]);
  camera.R_VC[2] = backward;
  camera.tanHalfFovY = static_cast<float>(std::tan(0.5 * static_cast<double>(fovY_rad)));
  camera.size_px = size_px;
  camera.centre_px = 0.5f * size_px;
  return camera;
}

Camera moved(const Camera& camera, glm::vec3 by_V) {
  Camera other = camera;
  other.eye_V += by_V;
  return other;
}

Camera orthographic(const Camera& camera, glm::vec3 target_V) {
  const float depth = depthOf(camera, target_V);
  POINSOT_EXPECT(depth > 0);
  Camera parallel = camera;
  parallel.halfHeight_V = 0.5f * camera.size_px.y / camera.scale_px(depth);
  parallel.orthographic = true;
  return parallel;
}

glm::vec3 toCamera(const Camera& camera, glm::vec3 point_V) { return (point_V - camera.eye_V) * camera.R_VC; }

float depthOf(const Camera& camera, glm::vec3 point_V) { return -toCamera(camera, point_V).z; }

glm::vec2 project(const Camera& camera, glm::vec3 point_V) {
  const glm::vec3 p_C = toCamera(camera, point_V);
  POINSOT_EXPECT(p_C.z < 0);
  return camera.centre_px + camera.scale_px(-p_C.z) * glm::vec2(p_C.x, -p_C.y);
}

}  // namespace poinsot::draw
