// SPDX-License-Identifier: Apache-2.0
#include "render/ellipsoid_rays.h"

#include <glm/matrix.hpp>

namespace poinsot::render {
namespace {

void append(Constants& to, const glm::mat3& matrix, glm::vec3 beside) {
  for (int i = 0; i < 3; ++i) to.emplace_back(matrix[i], beside[i]);
}

}  // namespace

EllipsoidRays ellipsoidRays(const draw::Camera& camera, glm::vec3 centre_C, const glm::mat3& semiAxes_C,
                            glm::vec2 origin_px) {
  const glm::dmat3 toUnitSphere = glm::inverse(glm::dmat3(semiAxes_C));
  const glm::dvec3 centre(centre_C);
  const auto focal_px = static_cast<double>(camera.focal_px());
  const glm::dvec2 q = (glm::dvec2(origin_px) - glm::dvec2(camera.centre_px)) / focal_px;
  const double distance = -centre.z;
  // Length of a pixel's side at the centre's distance, and its growth with distance (0 for parallel rays).
  const double side = (camera.orthographic ? 1 : distance) / focal_px;
  const double growth = camera.orthographic ? 0 : 1 / focal_px;
  const glm::dvec3 right = toUnitSphere[0], down = -toUnitSphere[1];
  const glm::dvec2 at = focal_px * side * q;  // point of the ray through origin_px, at the centre's distance
  const glm::dvec3 along(growth * focal_px * q.x, -growth * focal_px * q.y, -1);
  EllipsoidRays rays;
  rays.from_S =
      glm::dmat3(side * right, side * down, toUnitSphere * glm::dvec3(at.x - centre.x, -at.y - centre.y, 0));
  rays.along_S = glm::dmat3(growth * right, growth * down, toUnitSphere * along);
  rays.toUnitSphere = toUnitSphere;
  rays.centreDistance = static_cast<float>(distance);
  return rays;
}

void append(Constants& to, const EllipsoidRays& rays, const ScreenEllipse& outline, glm::vec3 beside) {
  append(to, rays.from_S, {outline.centre_px, rays.centreDistance});
  append(to, rays.along_S, outline.form);
  append(to, rays.toUnitSphere, beside);
}

}  // namespace poinsot::render
