// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/glm_layout.h"

namespace poinsot::draw {

/// A camera in the picture's axes V: a pinhole, or parallel rays. C: x right, y up, looking along -z.
struct Camera {
  glm::vec3 eye_V{0, 0, 5};
  glm::mat3 R_VC{1};          ///< columns: right, up, backward in V
  float tanHalfFovY = 0.2f;   ///< half the picture's height at unit distance
  bool orthographic = false;  ///< parallel rays; eye_V is then where distances count from
  float halfHeight_V = 1;     ///< half the picture's height, when orthographic
  float near = 0.1f;          ///< nearest and farthest distance along the view direction that is drawn
  float far = 100.0f;
  glm::vec2 size_px{1, 1};          ///< width, height of the picture
  glm::vec2 centre_px{0.5f, 0.5f};  ///< where the optical axis meets the picture, y down

  /// Pixels per unit length at unit distance; at any distance when orthographic.
  float focal_px() const { return 0.5f * size_px.y / (orthographic ? halfHeight_V : tanHalfFovY); }
  /// Pixels per unit length across the view, at a distance along it.
  float scale_px(float depth) const { return orthographic ? focal_px() : focal_px() / depth; }
};

/// Camera at `eye_V` looking at `target_V`, `up_V` upright in the picture; the optical axis in its middle.
/// @pre eye and target differ; up is not along the view.
Camera lookAt(glm::vec3 eye_V, glm::vec3 target_V, glm::vec3 up_V, float fovY_rad, glm::vec2 size_px);

/// The same camera elsewhere, farther by `by_V`.
Camera moved(const Camera& camera, glm::vec3 by_V);

/// The same view with parallel rays, as large as it is at `target_V`. @pre depthOf(camera, target_V) > 0.
Camera orthographic(const Camera& camera, glm::vec3 target_V);

/// A point's coordinates in camera axes C.
glm::vec3 toCamera(const Camera& camera, glm::vec3 point_V);

/// Distance of a point along the view direction; positive in front of the camera.
float depthOf(const Camera& camera, glm::vec3 point_V);

/// Where a point appears, in pixels from the top left corner, y down. @pre depthOf(...) > 0.
glm::vec2 project(const Camera& camera, glm::vec3 point_V);

static_assert(core::laidOut<Camera, 84, 4>());

}  // namespace poinsot::draw
