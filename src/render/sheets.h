// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <vector>

#include "draw/draw_list.h"
#include "gl/shader_program.h"
#include "render/frustum_outline.h"
#include "render/screen_outline.h"

/// The translucent sheets of a draw list, as composite.frag takes them.
namespace poinsot::render {

/// Some of the sheets of a list, by kind and number.
struct SheetChoice {
  std::vector<std::size_t> ellipsoids, planes, cones, polygons;
  auto operator<=>(const SheetChoice&) const = default;
  bool empty() const { return *this == SheetChoice{}; }
};

/// How many of each kind a shader is made for.
struct SheetCounts {
  std::size_t ellipsoids = 0, planes = 0, cones = 0, polygons = 0, polygonSides = 0;
  auto operator<=>(const SheetCounts&) const = default;
};

struct EllipsoidSheet {
  glm::vec3 centre_C;
  glm::mat3 toUnitSphere;
  ScreenEllipse outline;
};

struct PlaneSheet {
  glm::vec3 centre_C, u_C, v_C, normal_C;
  std::array<glm::vec3, 4> edges;
  PixelBounds bounds;  ///< empty when it is not wholly in front of the camera; so with all sheets
};

struct ConeSheet {
  FrustumOutline outline;  ///< from the apex to the base
  float slope = 0;         ///< radius / height
};

struct PolygonSheet {
  std::vector<glm::vec3> edges;    ///< in the picture; none when it is not to be seen
  std::vector<glm::vec2> corners;  ///< there
  glm::vec3 normal_C{0, 0, 1}, point_C{0};
  glm::vec2 depths{0};  ///< of the nearest corner and of the farthest
  PixelBounds bounds;
};

/// The sheets of one list, worked out for its camera. The list must outlive it.
class Sheets {
 public:
  /// @pre cones have half-angles below a right angle, polygons 3 to 16 corners.
  explicit Sheets(const draw::DrawList& list);

  /// Which of them a part of the picture is drawn with: all that it may show, and for the sake of fewer shaders
  /// some that it does not.
  SheetChoice reaching(const PixelBounds& part) const;
  static constexpr std::size_t kMostCorners = 16;
  SheetCounts counts(const SheetChoice& chosen) const;
  /// For a program made for as many sheets as are chosen.
  void setUniforms(const gl::ShaderProgram& program, const SheetChoice& chosen) const;

 private:
  const draw::DrawList& list_;
  std::vector<EllipsoidSheet> ellipsoids_;
  std::vector<PlaneSheet> planes_;
  std::vector<ConeSheet> cones_;
  std::vector<PolygonSheet> polygons_;
};

EllipsoidSheet ellipsoidSheet(const draw::Camera& camera, const draw::GlassEllipsoid& ellipsoid);
PlaneSheet planeSheet(const draw::Camera& camera, const draw::GridPlane& plane);
ConeSheet coneSheet(const draw::Camera& camera, const draw::GlassCone& cone);
PolygonSheet polygonSheet(const draw::Camera& camera, const draw::GlassPolygon& polygon);

}  // namespace poinsot::render
