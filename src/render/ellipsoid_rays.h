// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "draw/camera.h"
#include "render/constants.h"
#include "render/screen_outline.h"

namespace poinsot::render {

/// Rays from the eye through the pixels around an ellipsoid, in the space S in which the ellipsoid is the unit
/// sphere. Points and directions of rays are linear functions of the pixel. The columns of from_S and along_S hold
/// the change per pixel to the right, the change per pixel down, and the value at `origin_px`
/// (ray_ellipsoid.glsl).
struct EllipsoidRays {
  glm::mat3 from_S{0};        ///< point of the ray at the distance of the ellipsoid's centre
  glm::mat3 along_S{0};       ///< change of the ray's point per unit of distance along the view
  glm::mat3 toUnitSphere{1};  ///< matrix that transforms vectors from camera axes C to S
  float centreDistance = 0;   ///< distance of the ellipsoid's centre along the view
};

/// Returns the rays around an ellipsoid.
/// @param semiAxes_C  semi-axes as columns, in camera axes
/// @pre the centre is in front of the camera.
EllipsoidRays ellipsoidRays(const draw::Camera& camera, glm::vec3 centre_C, const glm::mat3& semiAxes_C,
                            glm::vec2 origin_px);

/// Appends the nine constants that rayEllipsoid() of ray_ellipsoid.glsl reads.
/// @param beside  w components of the last three constants
void append(Constants& to, const EllipsoidRays& rays, const ScreenEllipse& outline,
            glm::vec3 beside = glm::vec3(0));

}  // namespace poinsot::render
