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

namespace poinsot::render {

/// Sheets that a part of the picture shows: indices into the list, by kind.
struct SheetChoice {
  std::vector<std::size_t> ellipsoids, planes, cones, polygons;
  bool outlines = false;  ///< whether a sheet may end in the part; otherwise each one fills it
  bool shadows = false;   ///< whether a plane's shadow may be in the part; otherwise none is drawn
  auto operator<=>(const SheetChoice&) const = default;
  bool empty() const { return ellipsoids.empty() && planes.empty() && cones.empty() && polygons.empty(); }
};

/// Number of sheets of each kind that a shader is made for.
struct SheetCounts {
  std::size_t ellipsoids = 0, planes = 0, cones = 0, polygons = 0, polygonSides = 0;
  auto operator<=>(const SheetCounts&) const = default;  // NOLINT(modernize-use-nullptr): of what is made here
  std::size_t constants() const;
  /// Returns how many fragments of sheets a pixel can show. Ellipsoids and cones have two walls, cones also a rim.
  std::size_t fragments() const { return 2 * ellipsoids + planes + 3 * cones + polygons; }
};

struct EllipsoidSheet {
  EllipsoidRays rays;
  ScreenEllipse outline;
};

/// Grid plane in the picture, with its centre at middle_px. Its coordinates and depth are quotients of linear
/// functions of the pixel. Each function is stored as its change per pixel to the right, its change per pixel
/// down, and its value at middle_px.
struct PlaneSheet {
  glm::vec2 middle_px{0};
  glm::vec3 u{0}, v{0};                  ///< coordinates from the plane's centre, in grid spacings
  glm::vec3 depth{0}, divisor{0, 0, 1};  ///< depth as stored, 0 to 1; the divisor is 1 at middle_px
  std::array<glm::vec3, 4> edges{};
  float border_px = 0;
  PixelBounds bounds;  ///< empty, as for all sheets, if not wholly in front of the camera
  PixelBounds shadow;  ///< where the shadow may be; empty if there is none
};

struct ConeSheet {
  FrustumOutline outline;
  float slope = 0;  ///< radius / height
};

struct PolygonSheet {
  std::vector<glm::vec3> edges;  ///< in the picture; empty if the polygon is not visible
  std::vector<glm::vec2> corners;
  glm::vec3 normal_C{0, 0, 1}, point_C{0};
  glm::vec2 depths{0};  ///< distances of the nearest and the farthest corner
  PixelBounds bounds;
};

/// Translucent sheets of one list, as composite.frag takes them, projected by the list's camera. The list must
/// outlive this object.
class Sheets {
 public:
  /// @pre cones have half-angles below a right angle, polygons 3 to 16 corners.
  explicit Sheets(const draw::DrawList& list);

  /// Returns all sheets that a part of the picture may show.
  SheetChoice reaching(const PixelBounds& part) const;
  /// Adds all planes to a choice that is costly anyway, so that fewer shaders need to be compiled.
  void addPlanesTo(SheetChoice& chosen) const;
  static constexpr std::size_t kMostCorners = 16;
  SheetCounts counts(const SheetChoice& chosen) const;
  /// Returns the constants of the chosen sheets, for a program made for their counts().
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
