// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/abi.h"
#include "draw/camera.h"
#include "draw/color.h"

/// Content of a picture as plain values: no GL, no physics, no files. Lengths are along the picture's axes V,
/// widths of lines and sizes of type in pixels, colours in linear light.
namespace poinsot::draw {

/// Response of a solid to light. A `gloss` of 0 is chalk, 1 a hard highlight.
struct Material {
  Color color{0.5f};
  float gloss = 0.35f;
};

// ---- solids: opaque, exact silhouettes --------------------------------------------------------------------

/// Lines on an ellipsoid: parallels and meridians about its axes, in the ellipsoid's own angles.
struct Graticule {
  Color color{0};
  float width_px = 1.4f;
  float opacity = 1.0f;
  float farOpacity = 0.35f;  ///< opacity on the far wall of a translucent ellipsoid
};

/// Solid ellipsoid; the columns of `semiAxes_V` are its three semi-axis vectors. If `marking_px` > 0, it bears
/// lines of that width: rings about the third axis and four meridians, of which the one through the first axis is
/// heavy.
struct Ellipsoid {
  glm::vec3 centre_V{0};
  glm::mat3 semiAxes_V{1};
  Material material;
  Color markingColor{0};
  float marking_px = 0;
};

/// Solid of revolution between two discs: a cylinder, a cone (one radius 0) or a truncated cone.
struct Frustum {
  glm::vec3 from_V{0};
  glm::vec3 to_V{0, 0, 1};
  float fromRadius = 1;
  float toRadius = 1;
  Material material;
};

/// Solid box; the columns of `halfAxes_V` are half its edges.
struct Box {
  glm::vec3 centre_V{0};
  glm::mat3 halfAxes_V{1};
  Material material;
};

/// Surface of a body in mesh axes M: closed, without cracks, each triangle counter-clockwise seen from outside.
/// Neighbouring triangles share the indices of their vertices. Lengths have any unit; Mesh::axes_V converts them
/// to V.
struct TriangleMesh {
  std::vector<glm::vec3> vertices_M;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Solid with the surface `mesh`, at origin_V + axes_V x_M. The columns of `axes_V` are the M axes, scaled to V
/// and right-handed. Edges whose faces meet at more than `crease_rad` (in M) are sharp: they have flat normals on
/// either side and, if `edge_px` > 0, a line of that width in `edgeColor`. Other edges are shaded smoothly. A null
/// mesh draws nothing; a solid that is not wholly in front of the camera is left out. Share one TriangleMesh
/// between pictures, because data made from it is cached by its address.
struct Mesh {
  std::shared_ptr<const TriangleMesh> mesh;
  glm::vec3 origin_V{0};
  glm::mat3 axes_V{1};
  float crease_rad = 0.6f;
  Material material;
  Color edgeColor{0};
  float edge_px = 0;
};

/// Smooth line through points. If `radius_V` > 0, it is a shaded round tube of that radius, otherwise a flat line
/// of constant width. `lift_V` moves it towards the viewer, so that a line on a surface appears in front of the
/// surface.
struct Curve {
  std::vector<glm::vec3> points_V;
  bool closed = false;
  float width_px = 2;
  float radius_V = 0;
  float lift_V = 0;
  Material material;
};

// ---- sheets: translucent, composed per pixel in the right order ---------------------------------------------

/// Hollow ellipsoid of tinted glass, with `rimOpacity` at its rim. Seen flat-on, the near wall may be thinner than
/// the far wall, so that what is inside keeps its hue.
struct GlassEllipsoid {
  glm::vec3 centre_V{0};
  glm::mat3 semiAxes_V{1};
  Color color{1};
  float nearOpacity = 0.07f;
  float farOpacity = 0.15f;
  float rimOpacity = 0.45f;
  std::optional<Graticule> graticule;
};

/// Circular cone of tinted glass: the surface alone, open at its base, with a solid line around the base.
/// `nearOpacity` applies where the outside faces the eye, `farOpacity` where the inside does. A cone that is not
/// wholly in front of the camera is left out.
struct GlassCone {
  glm::vec3 apex_V{0};
  glm::vec3 axis_V{0, 0, 1};   ///< from the apex into the cone; any length
  float halfAngle_rad = 0.5f;  ///< in (0, pi/2)
  float height_V = 1;          ///< from the apex to the base, along the axis
  Color color{1};
  float nearOpacity = 0.07f;
  float farOpacity = 0.15f;
  float rimOpacity = 0.45f;  ///< where the surface is seen edge-on
  Color lineColor{0};
  float lineOpacity = 1;
  float lineWidth_px = 2;
};

/// Flat convex sheet with 3 to 16 corners, in order around it and in one plane, and a border line just inside. A
/// polygon that is not wholly in front of the camera is left out.
struct GlassPolygon {
  std::vector<glm::vec3> corners_V;
  Color color{1};
  float opacity = 0.15f;
  Color lineColor{0};
  float lineOpacity = 1;
  float lineWidth_px = 1.5f;
};

/// Rectangle with a square grid; `u_V` and `v_V` are perpendicular half-edges.
struct GridPlane {
  glm::vec3 centre_V{0};
  glm::vec3 u_V{1, 0, 0};
  glm::vec3 v_V{0, 1, 0};
  float spacing_V = 0.25f;  ///< between lines; a line runs through the centre in both directions
  Color color{1};
  float opacity = 0.12f;
  Color lineColor{0};
  float lineOpacity = 0.5f;
  float lineWidth_px = 1.5f;
  // Soft dark spot under a body on the plane. At r radii from its centre it has the opacity shadowOpacity · (2^(-2
  // r²) - kShadowEnd), if positive. Beyond r = kShadowReach an 8-bit picture would not show it.
  static constexpr float kShadowEnd = 1.0f / 512, kShadowReach = 2.1213204f;  // sqrt(4.5)
  glm::vec3 shadowCentre_V{0};
  float shadowRadius_V = 0;
  float shadowOpacity = 0;
};

// ---- text: always in front -----------------------------------------------------------------------------------

/// One line of type. `tex` uses the small TeX subset of text/math_setter.h. `baseline_px` is the left end of the
/// baseline from the picture's top left corner, y down.
struct Text {
  std::string tex;
  glm::vec2 baseline_px{0};
  float size_px = 32;
  Color color{0};
  float opacity = 1;          ///< opacity of glyphs and halo
  std::optional<Color> halo;  ///< colour of a rim around the glyphs that keeps them legible over lines
  float halo_px = 0;
};

struct DrawList {
  Camera camera;
  Color background{1};
  glm::vec3 lightDirection_C{-0.5f, 0.72f, 0.48f};  ///< towards the light, which travels with the camera
  std::vector<Ellipsoid> ellipsoids;
  std::vector<Frustum> frustums;
  std::vector<Box> boxes;
  std::vector<Mesh> meshes;
  std::vector<Curve> curves;
  std::vector<GlassEllipsoid> glassEllipsoids;
  std::vector<GlassCone> glassCones;
  std::vector<GlassPolygon> glassPolygons;
  std::vector<GridPlane> planes;
  std::vector<Text> texts;
};

static_assert(core::laidOut<Material, 16, 4>() && core::laidOut<Graticule, 24, 4>() &&
              core::laidOut<Ellipsoid, 80, 4>() && core::laidOut<Frustum, 48, 4>() &&
              core::laidOut<Box, 64, 4>() && core::laidOut<GlassEllipsoid, 100, 4>() &&
              core::laidOut<GlassCone, 76, 4>() && core::laidOut<GridPlane, 96, 4>());

}  // namespace poinsot::draw
