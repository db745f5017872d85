// SPDX-License-Identifier: Apache-2.0
#include "render/screen_outline.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace poinsot::render {
namespace {

// Margin around an outline for its soft edge, which extends half a pixel to either side, and for rounding.
constexpr float kOutlineMargin_px = 1.5f;
// Constant that is added to the squared semi-axes of an outline. It keeps numbers finite for a disc seen edge-on.
// The change of at most 0.03 px is not visible.
constexpr double kThinnest2_px2 = 1e-3;

// Returns the dual conic of the outline as a matrix, scaled so that its last element is -1.
glm::dmat3 dualConic(const draw::Camera& camera, const glm::dvec3& c, const glm::dmat3& A) {
  const double f = static_cast<double>(camera.focal_px());
  const glm::dvec2 middle(camera.centre_px);
  if (camera.orthographic) {
    // With parallel rays, p_px = L x + middle. A and c are therefore projected separately.
    const glm::dmat3 L(f, 0, 0, 0, -f, 0, 0, 0, 0);
    const glm::dvec3 p = L * c + glm::dvec3(middle, 1);
    return L * A * glm::transpose(A) * glm::transpose(L) - glm::outerProduct(p, p);
  }
  // With perspective, p_px = (K x) / (K x).z. The camera axes are x right, y up, z backward.
  const glm::dmat3 K(f, 0, 0, 0, -f, 0, -middle.x, -middle.y, -1);
  const glm::dmat3 dual = K * (A * glm::transpose(A) - glm::outerProduct(c, c)) * glm::transpose(K);
  return dual / -dual[2][2];
}

}  // namespace

void PixelBounds::include(glm::vec2 p_px, float margin) {
  left = std::min(left, p_px.x - margin);
  right = std::max(right, p_px.x + margin);
  top = std::min(top, p_px.y - margin);
  bottom = std::max(bottom, p_px.y + margin);
}

void PixelBounds::include(const PixelBounds& other) {
  if (other.empty()) return;
  include(glm::vec2(other.left, other.top));
  include(glm::vec2(other.right, other.bottom));
}

PixelBounds PixelBounds::clipped(glm::vec2 size_px) const {
  PixelBounds whole;
  whole.left = std::max(0.0f, std::floor(left));
  whole.top = std::max(0.0f, std::floor(top));
  whole.right = std::min(size_px.x, std::ceil(right));
  whole.bottom = std::min(size_px.y, std::ceil(bottom));
  return whole;
}

bool ScreenEllipse::inside(glm::vec2 p_px) const {
  const glm::vec2 q = p_px - centre_px;
  return form.x * q.x * q.x + 2 * form.y * q.x * q.y + form.z * q.y * q.y <= 1;
}

ScreenEllipse ellipseOutline(const draw::Camera& camera, glm::vec3 centre_C, const glm::mat3& semiAxes_C) {
  const glm::dmat3 N = dualConic(camera, glm::dvec3(centre_C), glm::dmat3(semiAxes_C));
  const glm::dvec2 centre(-N[2][0], -N[2][1]);
  const double xx = N[0][0] + centre.x * centre.x + kThinnest2_px2;
  const double yy = N[1][1] + centre.y * centre.y + kThinnest2_px2;
  const double xy = N[0][1] + centre.x * centre.y;
  const double determinant = std::max(xx * yy - xy * xy, kThinnest2_px2 * kThinnest2_px2);
  ScreenEllipse outline;
  outline.centre_px = centre;
  outline.form = glm::dvec3(yy, -xy, xx) / determinant;
  const glm::vec2 half(glm::dvec2(std::sqrt(xx), std::sqrt(yy)));
  outline.bounds.include(outline.centre_px - half, kOutlineMargin_px);
  outline.bounds.include(outline.centre_px + half, kOutlineMargin_px);
  return outline;
}

bool inFront(const draw::Camera& camera, glm::vec3 centre_C, const glm::mat3& semiAxes_C) {
  const glm::vec3 zRow(semiAxes_C[0].z, semiAxes_C[1].z, semiAxes_C[2].z);
  return -centre_C.z - glm::length(zRow) > camera.near;
}

glm::vec3 lineThrough(glm::vec2 a, glm::vec2 b, glm::vec2 inside) {
  const glm::dvec2 direction = glm::dvec2(b) - glm::dvec2(a);
  const double length = std::max(glm::length(direction), 1e-9);
  glm::dvec2 normal(-direction.y / length, direction.x / length);
  if (glm::dot(normal, glm::dvec2(inside) - glm::dvec2(a)) < 0) normal = -normal;
  return {normal.x, normal.y, -glm::dot(normal, glm::dvec2(a))};
}

std::array<glm::vec3, 4> quadEdges(const std::array<glm::vec2, 4>& corners) {
  const glm::vec2 middle = 0.25f * (corners[0] + corners[1] + corners[2] + corners[3]);
  std::array<glm::vec3, 4> edges;
  for (std::size_t i = 0; i < 4; ++i) edges[i] = lineThrough(corners[i], corners[(i + 1) % 4], middle);
  return edges;
}

glm::vec3 sightAt(const draw::Camera& camera, glm::vec3 point_C) {
  return camera.orthographic ? glm::vec3(0, 0, -1) : point_C;
}

glm::vec2 projectCamera(const draw::Camera& camera, glm::vec3 point_C) {
  return camera.centre_px + camera.scale_px(-point_C.z) * glm::vec2(point_C.x, -point_C.y);
}

}  // namespace poinsot::render
