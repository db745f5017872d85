// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "draw/camera.h"
#include "render/constants.h"
#include "render/screen_outline.h"

namespace poinsot::render {

/// The rays through the pixels about an ellipsoid, in the space S in which it is the unit sphere, as
/// ray_ellipsoid.glsl takes them: columns for a pixel to the right, for one down, and for the pixel at
/// `origin_px`.
struct EllipsoidRays {
  glm::mat3 from_S{0};        ///< a ray's point at the distance of the centre
  glm::mat3 along_S{0};       ///< its change per unit of distance along the view
  glm::mat3 toUnitSphere{1};  ///< takes C, seen from the centre, to S
  float centreDistance = 0;   ///< along the view
};

/// @param semiAxes_C  as columns, in camera axes
/// @pre the centre is in front of the camera.
EllipsoidRays ellipsoidRays(const draw::Camera& camera, glm::vec3 centre_C, const glm::mat3& semiAxes_C,
                            glm::vec2 origin_px);

/// The nine constants that rayEllipsoid() of ray_ellipsoid.glsl takes, and three beside the last of them.
void append(Constants& to, const EllipsoidRays& rays, const ScreenEllipse& outline,
            glm::vec3 beside = glm::vec3(0));

}  // namespace poinsot::render
