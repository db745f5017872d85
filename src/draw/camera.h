// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/glm_layout.h"

namespace poinsot::draw {

/// Camera in the picture's axes V: a pinhole, or parallel rays. Camera axes C: x right, y up, looking along -z.
struct Camera {
  glm::vec3 eye_V{0, 0, 5};
  glm::mat3 R_VC{1};          ///< columns: right, up, backward in V
  float tanHalfFovY = 0.2f;   ///< half the picture's height at unit distance
  bool orthographic = false;  ///< parallel rays; distances are then measured from eye_V
  float halfHeight_V = 1;     ///< half the picture's height, if orthographic
  float near = 0.1f;          ///< nearest and farthest drawn distance along the view direction
  float far = 100.0f;
  glm::vec2 size_px{1, 1};
  glm::vec2 centre_px{0.5f, 0.5f};  ///< where the optical axis meets the picture, y down

  /// Returns pixels per unit length at unit distance, or at any distance if orthographic.
  float focal_px() const { return 0.5f * size_px.y / (orthographic ? halfHeight_V : tanHalfFovY); }
  /// Returns pixels per unit length across the view, at a distance along the view.
  float scale_px(float depth) const { return orthographic ? focal_px() : focal_px() / depth; }
};

/// Returns a camera at `eye_V` that looks at `target_V`, with `up_V` upright and the optical axis in the middle of
/// the picture.
/// @pre eye and target differ; up is not along the view.
Camera lookAt(glm::vec3 eye_V, glm::vec3 target_V, glm::vec3 up_V, float fovY_rad, glm::vec2 size_px);

Camera moved(const Camera& camera, glm::vec3 by_V);

/// Returns the same view with parallel rays. Its scale is that of `camera` at `target_V`.
/// @pre depthOf(camera, target_V) > 0.
Camera orthographic(const Camera& camera, glm::vec3 target_V);

glm::vec3 toCamera(const Camera& camera, glm::vec3 point_V);

/// Returns the distance of a point along the view direction; positive in front of the camera.
float depthOf(const Camera& camera, glm::vec3 point_V);

/// Projects a point to pixels from the top left corner of the picture, y down. @pre depthOf(...) > 0.
glm::vec2 project(const Camera& camera, glm::vec3 point_V);

static_assert(core::laidOut<Camera, 84, 4>());

}  // namespace poinsot::draw
