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

/// Sheets (translucent surfaces) that a part of the picture shows, as indices into the draw list.
struct SheetChoice {
  std::vector<std::size_t> ellipsoids, planes, cones, polygons;
  bool outlines = false;  ///< whether the part may contain the edge of a sheet; if not, each sheet fills the part
  bool shadows = false;   ///< whether the part may contain the shadow on a plane; if not, no shadow is drawn
  auto operator<=>(const SheetChoice&) const = default;
  bool empty() const { return ellipsoids.empty() && planes.empty() && cones.empty() && polygons.empty(); }
};

/// Number of sheets of each kind for which a shader is compiled.
struct SheetCounts {
  std::size_t ellipsoids = 0, planes = 0, cones = 0, polygons = 0, polygonSides = 0;
  auto operator<=>(const SheetCounts&) const = default;  // NOLINT(modernize-use-nullptr): of what is made here
  std::size_t constants() const;
  /// Returns the most sheet surfaces in one pixel. Ellipsoids have two walls; cones have two walls and a rim.
  std::size_t fragments() const { return 2 * ellipsoids + planes + 3 * cones + polygons; }
};

struct EllipsoidSheet {
  EllipsoidRays rays;
  ScreenEllipse outline;
};

/// Grid plane as seen in the picture. Its grid coordinates and depth are quotients of two linear functions of the
/// pixel. Each linear function is stored as three numbers: change per pixel to the right, change per pixel down,
/// and value at middle_px, the pixel position of the plane's centre.
struct PlaneSheet {
  glm::vec2 middle_px{0};
  glm::vec3 u{0}, v{0};  ///< numerators of the coordinates from the plane's centre, in grid spacings
  /// Numerator of the stored depth (0 to 1), and the common divisor, which is 1 at middle_px
  glm::vec3 depth{0}, divisor{0, 0, 1};
  std::array<glm::vec3, 4> edges{};
  float border_px = 0;
  PixelBounds bounds;  ///< empty if the plane is not completely in front of the camera
  PixelBounds shadow;  ///< part of the picture that the shadow may darken; empty without a shadow
};

struct ConeSheet {
  FrustumOutline outline;
  float slope = 0;  ///< radius of the base divided by the height
};

struct PolygonSheet {
  std::vector<glm::vec3> edges;  ///< lines (nx, ny, c) in the picture; empty if the polygon is not visible
  std::vector<glm::vec2> corners;
  glm::vec3 normal_C{0, 0, 1}, point_C{0};
  glm::vec2 depths{0};  ///< distances of the nearest and of the farthest corner along the view
  PixelBounds bounds;
};

/// Translucent sheets of a draw list, projected for composite.frag. The list must outlive this object.
class Sheets {
 public:
  /// @pre cones have half-angles below a right angle, polygons 3 to 16 corners.
  explicit Sheets(const draw::DrawList& list);

  /// Returns all sheets that may be visible in a part of the picture.
  SheetChoice reaching(const PixelBounds& part) const;
  /// Adds all planes to the choice. For parts that are slow to draw anyway, this saves shaders.
  void addPlanesTo(SheetChoice& chosen) const;
  static constexpr std::size_t kMostCorners = 16;
  SheetCounts counts(const SheetChoice& chosen) const;
  /// Returns the constants of the chosen sheets, for a program that was compiled for counts(chosen).
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
