// SPDX-License-Identifier: Apache-2.0
#include "render/frustum_outline.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace poinsot::render {
namespace {

// Returns two unit vectors that form a right-handed frame with `axis`.
std::array<glm::vec3, 2> perpendiculars(glm::vec3 axis) {
  const glm::vec3 other = std::abs(axis.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 first = glm::normalize(glm::cross(axis, other));
  return {first, glm::cross(axis, first)};
}

// Returns the two straight lines of the side that lie on the silhouette, as unit vectors from the axis.
// On the silhouette the normal of the side is perpendicular to the sight line: n·p = 0 with n = radial - slope
// axis and p = sight + radius radial. Here `sight` is the vector from the eye to from_C. With parallel rays,
// `sight` is the direction of the rays and p = sight. Written with the angle φ about the axis:
//   a cos φ + b sin φ = slope (axis·sight) - radius,    a, b = e1·sight, e2·sight
// Returns nullopt if the eye is inside the cone or its extension, because one disc then covers the other.
std::optional<std::array<glm::vec3, 2>> silhouetteRulings(glm::vec3 sight_C, glm::vec3 axis_C, float radius,
                                                          float slope) {
  const auto [e1, e2] = perpendiculars(axis_C);
  const float a = glm::dot(e1, sight_C), b = glm::dot(e2, sight_C);
  const float c = slope * glm::dot(axis_C, sight_C) - radius;
  const float r = std::hypot(a, b);
  if (std::abs(c) >= r) return std::nullopt;
  const float cosine = c / r, sine = std::sqrt(1 - cosine * cosine);
  const float ca = a / r, sa = b / r;
  return std::array<glm::vec3, 2>{(ca * cosine - sa * sine) * e1 + (sa * cosine + ca * sine) * e2,
                                  (ca * cosine + sa * sine) * e1 + (sa * cosine - ca * sine) * e2};
}

ScreenEllipse discOutline(const draw::Camera& camera, glm::vec3 centre_C, glm::vec3 axis_C, float radius) {
  const auto [e1, e2] = perpendiculars(axis_C);
  return ellipseOutline(camera, centre_C, glm::mat3(radius * e1, radius * e2, glm::vec3(0)));
}

}  // namespace

bool FrustumOutline::inside(glm::vec2 p_px) const {
  const auto within = [&](glm::vec3 e) { return glm::dot(glm::vec2(e), p_px) + e.z >= 0; };
  return first.inside(p_px) || second.inside(p_px) || std::all_of(sides.begin(), sides.end(), within);
}

FrustumOutline frustumOutline(const draw::Camera& camera, const draw::Frustum& f) {
  FrustumOutline outline;
  outline.from_C = toCamera(camera, f.from_V);
  const glm::vec3 to_C = toCamera(camera, f.to_V);
  outline.height = glm::distance(outline.from_C, to_C);
  const float reach = std::max(f.fromRadius, f.toRadius);
  if (outline.height <= 0 || -std::max(outline.from_C.z, to_C.z) - reach <= camera.near) return outline;
  outline.axis_C = (to_C - outline.from_C) / outline.height;
  outline.first = discOutline(camera, outline.from_C, outline.axis_C, f.fromRadius);
  outline.second = discOutline(camera, to_C, outline.axis_C, f.toRadius);
  outline.bounds.include(outline.first.bounds);
  outline.bounds.include(outline.second.bounds);
  outline.sides.fill(glm::vec3(0, 0, -1e6f));
  const glm::vec3 sight_C = sightAt(camera, outline.from_C);
  if (glm::dot(outline.axis_C, sight_C) > 0 && f.fromRadius > 0) outline.visibleCap = 1;
  if (glm::dot(outline.axis_C, sightAt(camera, to_C)) < 0 && f.toRadius > 0) outline.visibleCap = 2;

  const float slope = (f.toRadius - f.fromRadius) / outline.height;
  const auto rulings =
      silhouetteRulings(sight_C, outline.axis_C, camera.orthographic ? 0.0f : f.fromRadius, slope);
  if (!rulings) return outline;
  const auto corner = [&](glm::vec3 end_C, float radius, std::size_t k) {
    return projectCamera(camera, end_C + radius * (*rulings)[k]);
  };
  // The corners go along one silhouette line and back along the other: edges 0 and 2 are the silhouette.
  const std::array<glm::vec2, 4> corners{corner(outline.from_C, f.fromRadius, 0), corner(to_C, f.toRadius, 0),
                                         corner(to_C, f.toRadius, 1), corner(outline.from_C, f.fromRadius, 1)};
  outline.sides = quadEdges(corners);
  // At the tip of a cone the two silhouette lines meet, so the strip has no edge across.
  if (f.toRadius == 0) outline.sides[1] = glm::vec3(0, 0, 1e6f);
  if (f.fromRadius == 0) outline.sides[3] = glm::vec3(0, 0, 1e6f);
  return outline;
}

}  // namespace poinsot::render
