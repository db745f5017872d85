// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/glm_layout.h"

namespace poinsot::draw {

/// Camera with perspective or with parallel rays, in the picture's axes V. The camera axes C are x right, y up and
/// z backward, so the camera looks along -z.
struct Camera {
  glm::vec3 eye_V{0, 0, 5};
  glm::mat3 R_VC{1};         ///< rotation matrix; its columns are right, up and backward in V
  float tanHalfFovY = 0.2f;  ///< tangent of half the vertical field of view
  /// Whether rays are parallel; distances are then measured from the plane through eye_V
  bool orthographic = false;
  float halfHeight_V = 1;  ///< with parallel rays, half the height of the picture as a length in V
  float near = 0.1f;       ///< least and greatest distance along the view that is drawn
  float far = 100.0f;
  glm::vec2 size_px{1, 1};
  glm::vec2 centre_px{0.5f, 0.5f};  ///< point of the picture on the optical axis, y down

  /// Returns the number of pixels per unit of length at distance 1, or at any distance if rays are parallel.
  float focal_px() const { return 0.5f * size_px.y / (orthographic ? halfHeight_V : tanHalfFovY); }
  /// Returns the number of pixels per unit of length across the view, at a distance along the view.
  float scale_px(float depth) const { return orthographic ? focal_px() : focal_px() / depth; }
};

/// Returns a camera at `eye_V` that looks at `target_V`, with `up_V` upright and the optical axis in the middle of
/// the picture.
/// @param fovY_rad  vertical field of view
/// @pre eye and target differ; up is not along the view.
Camera lookAt(glm::vec3 eye_V, glm::vec3 target_V, glm::vec3 up_V, float fovY_rad, glm::vec2 size_px);

Camera moved(const Camera& camera, glm::vec3 by_V);

/// Returns a camera with parallel rays for the same view. At the distance of `target_V` its scale is that of
/// `camera`.
/// @pre depthOf(camera, target_V) > 0.
Camera orthographic(const Camera& camera, glm::vec3 target_V);

glm::vec3 toCamera(const Camera& camera, glm::vec3 point_V);

/// Returns the distance of a point along the view direction; positive in front of the camera.
float depthOf(const Camera& camera, glm::vec3 point_V);

/// Projects a point to pixels from the top left corner of the picture, y down. @pre depthOf(...) > 0.
glm::vec2 project(const Camera& camera, glm::vec3 point_V);

static_assert(core::laidOut<Camera, 84, 4>());

}  // namespace poinsot::draw
