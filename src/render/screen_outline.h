// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "draw/camera.h"

/// Exact outlines of solids in the picture, worked out on the CPU in double.
namespace poinsot::render {

/// An axis-aligned rectangle of pixels; empty when right < left.
struct PixelBounds {
  float left = 1e9f, top = 1e9f, right = -1e9f, bottom = -1e9f;

  void include(glm::vec2 p_px, float margin = 0);
  void include(const PixelBounds& other);
  bool empty() const { return right <= left || bottom <= top; }
  /// Whole pixels, clipped to the picture.
  PixelBounds clipped(glm::vec2 size_px) const;
  glm::vec4 asVec4() const { return {left, top, right, bottom}; }
};

/// The picture of an ellipsoid or a disc: rho² = (p - centre)ᵀ F (p - centre), 1 on the outline, F = (xx, xy, yy).
struct ScreenEllipse {
  glm::vec2 centre_px{0};
  glm::vec3 form{1, 0, 1};
  PixelBounds bounds;

  bool inside(glm::vec2 p_px) const;
};

/// Outline of x = centre + A s, |s| <= 1, in camera axes. A column of zeros makes a disc.
///
/// The dual conic of the outline is K (A Aᵀ - c cᵀ) Kᵀ, K the camera's 3x3 matrix: it exists for discs seen
/// edge-on too, where the conic itself does not. With parallel rays it is L A Aᵀ Lᵀ - p pᵀ, L the 2x3 matrix of
/// the camera and p the picture of the centre. Source: Hartley & Zisserman, Multiple View Geometry, 2nd ed.,
/// eq 8.5.
/// @pre the whole ellipsoid is in front of the camera.
ScreenEllipse ellipseOutline(const draw::Camera& camera, glm::vec3 centre_C, const glm::mat3& semiAxes_C);

/// True when the ellipsoid lies wholly in front of the camera's near distance.
bool inFront(const draw::Camera& camera, glm::vec3 centre_C, const glm::mat3& semiAxes_C);

/// The line through a and b as (nx, ny, c), its unit normal on the side of `inside`.
glm::vec3 lineThrough(glm::vec2 a, glm::vec2 b, glm::vec2 inside);

/// The four edges of a convex quadrilateral in order, each towards the inside.
std::array<glm::vec3, 4> quadEdges(const std::array<glm::vec2, 4>& corners);

/// From the eye towards a point in camera axes; of any length.
glm::vec3 sightAt(const draw::Camera& camera, glm::vec3 point_C);

/// Where a point in camera axes appears, in pixels, y down. @pre in front of the camera.
glm::vec2 projectCamera(const draw::Camera& camera, glm::vec3 point_C);

}  // namespace poinsot::render
