// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "draw/camera.h"
#include "render/constants.h"
#include "render/screen_outline.h"

namespace poinsot::render {

/// Rays through the pixels around an ellipsoid, in the space S in which the ellipsoid is the unit sphere. The
/// columns of from_S and along_S are the change for a pixel to the right, the change for a pixel down, and the
/// value at `origin_px` (ray_ellipsoid.glsl).
struct EllipsoidRays {
  glm::mat3 from_S{0};        ///< point of a ray at the centre's distance
  glm::mat3 along_S{0};       ///< change of that point per unit of distance along the view
  glm::mat3 toUnitSphere{1};  ///< takes vectors from the centre, in camera axes C, to S
  float centreDistance = 0;   ///< distance of the centre along the view
};

/// Returns the rays around an ellipsoid.
/// @param semiAxes_C  semi-axes as columns, in camera axes
/// @pre the centre is in front of the camera.
EllipsoidRays ellipsoidRays(const draw::Camera& camera, glm::vec3 centre_C, const glm::mat3& semiAxes_C,
                            glm::vec2 origin_px);

/// Appends the nine constants that rayEllipsoid() of ray_ellipsoid.glsl takes. `beside` fills the w components of
/// the last three.
void append(Constants& to, const EllipsoidRays& rays, const ScreenEllipse& outline,
            glm::vec3 beside = glm::vec3(0));

}  // namespace poinsot::render
