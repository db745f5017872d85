// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <vector>

#include "draw/draw_list.h"
#include "render/constants.h"
#include "render/ellipsoid_rays.h"
#include "render/frustum_outline.h"
#include "render/screen_outline.h"

/// The translucent sheets of a draw list, as composite.frag takes them.
namespace poinsot::render {

/// Some of the sheets of a list, by kind and number, as a part of the picture shows them.
struct SheetChoice {
  std::vector<std::size_t> ellipsoids, planes, cones, polygons;
  bool outlines = false;  ///< whether one of them may end there; else each fills the part
  bool shadows = false;   ///< whether a plane's shadow may be there; else none is drawn
  auto operator<=>(const SheetChoice&) const = default;
  bool empty() const { return ellipsoids.empty() && planes.empty() && cones.empty() && polygons.empty(); }
};

/// How many of each kind a shader is made for.
struct SheetCounts {
  std::size_t ellipsoids = 0, planes = 0, cones = 0, polygons = 0, polygonSides = 0;
  auto operator<=>(const SheetCounts&) const = default;  // NOLINT(modernize-use-nullptr): of what is made here
  std::size_t constants() const;
  /// How many of them a pixel can show: both walls of an ellipsoid, and of a cone its rim besides.
  std::size_t fragments() const { return 2 * ellipsoids + planes + 3 * cones + polygons; }
};

struct EllipsoidSheet {
  EllipsoidRays rays;
  ScreenEllipse outline;
};

/// Coordinates in the plane and depth are quotients of what changes evenly over the picture: by a pixel to the
/// right, by one down, and at the middle.
struct PlaneSheet {
  glm::vec2 middle_px{0};                ///< where the plane's centre appears
  glm::vec3 u{0}, v{0};                  ///< from the plane's centre, in spacings of its grid
  glm::vec3 depth{0}, divisor{0, 0, 1};  ///< depth as it is stored, 0 to 1; the divisor is 1 at the middle
  std::array<glm::vec3, 4> edges{};
  float border_px = 0;  ///< width of the line along them
  PixelBounds bounds;   ///< empty when it is not wholly in front of the camera; so with all sheets
  PixelBounds shadow;   ///< where it may be; empty when there is none
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

  /// Which of them a part of the picture is drawn with: all that it may show.
  SheetChoice reaching(const PixelBounds& part) const;
  /// All planes come along with what costs more anyway: fewer shaders to compile for the few places it concerns.
  void addPlanesTo(SheetChoice& chosen) const;
  static constexpr std::size_t kMostCorners = 16;
  SheetCounts counts(const SheetChoice& chosen) const;
  /// For a program made for as many sheets as are chosen.
  Constants constants(const SheetChoice& chosen) const;

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
