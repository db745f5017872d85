// SPDX-License-Identifier: Apache-2.0
#include "draw/camera.h"

#include <glm/geometric.hpp>

#include <cmath>

#include "core/expect.h"

namespace poinsot::draw {

Camera lookAt(glm::vec3 eye_W, glm::vec3 target_W, glm::vec3 up_W, float fovY_rad, glm::vec2 size_px) {
  POINSOT_EXPECT(eye_W != target_W);
  const glm::vec3 backward = glm::normalize(eye_W - target_W);
  const glm::vec3 right = glm::cross(up_W, backward);
  POINSOT_EXPECT(glm::length(right) > 1e-6f);
  Camera camera;
  camera.eye_W = eye_W;
  camera.R_WC[0] = glm::normalize(right);
  camera.R_WC[1] = glm::cross(backward, camera.R_WC[0]);
  camera.R_WC[2] = backward;
  camera.tanHalfFovY = static_cast<float>(std::tan(0.5 * static_cast<double>(fovY_rad)));
  camera.size_px = size_px;
  camera.centre_px = 0.5f * size_px;
  return camera;
}

Camera moved(const Camera& camera, glm::vec3 by_W) {
  Camera other = camera;
  other.eye_W += by_W;
  return other;
}

Camera orthographic(const Camera& camera, glm::vec3 target_W) {
  const float depth = depthOf(camera, target_W);
  POINSOT_EXPECT(depth > 0);
  Camera parallel = camera;
  parallel.halfHeight_W = 0.5f * camera.size_px.y / camera.scale_px(depth);
  parallel.orthographic = true;
  return parallel;
}

glm::vec3 toCamera(const Camera& camera, glm::vec3 point_W) { return (point_W - camera.eye_W) * camera.R_WC; }

float depthOf(const Camera& camera, glm::vec3 point_W) { return -toCamera(camera, point_W).z; }

glm::vec2 project(const Camera& camera, glm::vec3 point_W) {
  const glm::vec3 p_C = toCamera(camera, point_W);
  POINSOT_EXPECT(p_C.z < 0);
  return camera.centre_px + camera.scale_px(-p_C.z) * glm::vec2(p_C.x, -p_C.y);
}

}  // namespace poinsot::draw
