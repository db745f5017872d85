// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "draw/camera.h"

/// Outlines of solids in the picture, computed exactly on the CPU in double precision.
namespace poinsot::render {

/// Axis-aligned rectangle in pixels; empty if right <= left or bottom <= top.
struct PixelBounds {
  float left = 1e9f, top = 1e9f, right = -1e9f, bottom = -1e9f;

  void include(glm::vec2 p_px, float margin = 0);
  void include(const PixelBounds& other);
  bool empty() const { return right <= left || bottom <= top; }
  /// Returns the bounds, rounded outwards to whole pixels and clipped to the picture.
  PixelBounds clipped(glm::vec2 size_px) const;
  glm::vec4 asVec4() const { return {left, top, right, bottom}; }
};

/// Outline of an ellipsoid or a disc in the picture: an ellipse. For a point p, rho² = (p - centre)ᵀ F (p -
/// centre) with F = (xx, xy, yy). On the outline rho = 1; inside rho < 1.
struct ScreenEllipse {
  glm::vec2 centre_px{0};
  glm::vec3 form{1, 0, 1};
  PixelBounds bounds;

  bool inside(glm::vec2 p_px) const;
};

/// Returns the outline of the ellipsoid x = centre + A s, |s| <= 1, where the columns of A are the semi-axes in
/// camera axes. A column of zeros makes the ellipsoid a disc.
/// The dual conic of the outline is K (A Aᵀ - c cᵀ) Kᵀ, where K is the camera's 3x3 matrix. Unlike the conic, the
/// dual conic also exists for a disc seen edge-on. With parallel rays, the dual conic is L A Aᵀ Lᵀ - p pᵀ, where L
/// is the camera's 2x3 matrix and p is the centre's position in the picture. Source: Hartley & Zisserman, Multiple
/// View Geometry, 2nd ed., eq 8.5.
/// @pre the whole ellipsoid is in front of the camera.
ScreenEllipse ellipseOutline(const draw::Camera& camera, glm::vec3 centre_C, const glm::mat3& semiAxes_C);

/// Reports whether the complete ellipsoid is farther away than the camera's near distance.
bool inFront(const draw::Camera& camera, glm::vec3 centre_C, const glm::mat3& semiAxes_C);

/// Returns the line through a and b as (nx, ny, c), where nx x + ny y + c is the signed distance from the line.
/// The distance of the point `inside` is positive.
glm::vec3 lineThrough(glm::vec2 a, glm::vec2 b, glm::vec2 inside);

/// Returns the four edges of a convex quadrilateral as lines (nx, ny, c), with normals that point inwards.
std::array<glm::vec3, 4> quadEdges(const std::array<glm::vec2, 4>& corners);

/// Returns the direction from the eye to a point, in camera axes. The result is not a unit vector.
glm::vec3 sightAt(const draw::Camera& camera, glm::vec3 point_C);

/// Projects a point in camera axes to pixels, y down. @pre in front of the camera.
glm::vec2 projectCamera(const draw::Camera& camera, glm::vec3 point_C);

}  // namespace poinsot::render
