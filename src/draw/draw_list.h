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

/// Content of a picture as plain values, without OpenGL, physics or files. Lengths are measured in the picture's
/// axes V, line widths and text sizes in pixels. Colours are linear light.
namespace poinsot::draw {

/// Surface of a solid. A `gloss` of 0 is matt like chalk; 1 has a hard highlight.
struct Material {
  Color color{0.5f};
  float gloss = 0.35f;
};

// ---- solids: opaque, exact silhouettes --------------------------------------------------------------------

/// Lines on an ellipsoid: parallels and meridians about its own axes. Latitude and longitude are those of the unit
/// sphere that is stretched to the ellipsoid.
struct Graticule {
  Color color{0};
  float width_px = 1.4f;
  float opacity = 1.0f;
  float farOpacity = 0.35f;  ///< opacity on the far wall of a translucent ellipsoid
};

/// Solid ellipsoid. The columns of `semiAxes_V` are its three semi-axis vectors. If `marking_px` > 0, the surface
/// has lines of that width: rings about the third axis and four meridians. The meridian through the first axis is
/// wider.
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

/// Solid box. The columns of `halfAxes_V` are vectors from the centre to three faces.
struct Box {
  glm::vec3 centre_V{0};
  glm::mat3 halfAxes_V{1};
  Material material;
};

/// Closed surface of a body in mesh axes M. Each triangle is counter-clockwise seen from outside. Neighbouring
/// triangles have the indices of their common vertices in common, so the surface has no cracks. Lengths may have
/// any unit; Mesh::axes_V converts them to V.
struct TriangleMesh {
  std::vector<glm::vec3> vertices_M;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Solid bounded by `mesh`, whose point x_M is at origin_V + axes_V x_M. The columns of `axes_V` are the axes of
/// M, scaled to V and right-handed.
/// An edge is sharp if its faces meet at an angle of more than `crease_rad`, measured in M. At a sharp edge,
/// shading changes abruptly, and a line of width `edge_px` is drawn if `edge_px` > 0. Other edges are shaded
/// smoothly.
/// A null mesh draws nothing. A solid that is not completely in front of the camera is left out. Use the same
/// TriangleMesh in several pictures, because data computed from it is cached by its address.
struct Mesh {
  std::shared_ptr<const TriangleMesh> mesh;
  glm::vec3 origin_V{0};
  glm::mat3 axes_V{1};
  float crease_rad = 0.6f;
  Material material;
  Color edgeColor{0};
  float edge_px = 0;
};

/// Smooth line through points. If `radius_V` > 0, the line is a round tube of that radius, with shading. Otherwise
/// it is a flat line of width `width_px`. `lift_V` moves the line towards the viewer, so that a line on a surface
/// is not hidden by the surface.
struct Curve {
  std::vector<glm::vec3> points_V;
  bool closed = false;
  float width_px = 2;
  float radius_V = 0;
  float lift_V = 0;
  Material material;
};

// ---- sheets: translucent, composed per pixel in the right order ---------------------------------------------

/// Hollow ellipsoid of tinted glass. `nearOpacity` and `farOpacity` are the opacities of its two walls seen
/// flat-on; towards the rim they grow to `rimOpacity`. A smaller `nearOpacity` keeps the colours of things inside.
struct GlassEllipsoid {
  glm::vec3 centre_V{0};
  glm::mat3 semiAxes_V{1};
  Color color{1};
  float nearOpacity = 0.07f;
  float farOpacity = 0.15f;
  float rimOpacity = 0.45f;
  std::optional<Graticule> graticule;
};

/// Circular cone of tinted glass. It has no base; a solid line runs around the base. Where the outside faces the
/// eye, the opacity is `nearOpacity`; where the inside faces the eye, it is `farOpacity`. A cone that is not
/// completely in front of the camera is left out.
struct GlassCone {
  glm::vec3 apex_V{0};
  glm::vec3 axis_V{0, 0, 1};   ///< direction from the apex into the cone; its length has no effect
  float halfAngle_rad = 0.5f;  ///< angle between the axis and the surface, in (0, pi/2)
  float height_V = 1;          ///< distance from the apex to the base, along the axis
  Color color{1};
  float nearOpacity = 0.07f;
  float farOpacity = 0.15f;
  float rimOpacity = 0.45f;  ///< opacity where the surface is seen edge-on
  Color lineColor{0};
  float lineOpacity = 1;
  float lineWidth_px = 2;
};

/// Flat convex sheet with 3 to 16 corners. The corners lie in one plane and are listed in order around the sheet.
/// A line is drawn just inside the border. A polygon that is not completely in front of the camera is left out.
struct GlassPolygon {
  std::vector<glm::vec3> corners_V;
  Color color{1};
  float opacity = 0.15f;
  Color lineColor{0};
  float lineOpacity = 1;
  float lineWidth_px = 1.5f;
};

/// Rectangle with a square grid. `u_V` and `v_V` are perpendicular vectors from the centre to two sides.
struct GridPlane {
  glm::vec3 centre_V{0};
  glm::vec3 u_V{1, 0, 0};
  glm::vec3 v_V{0, 1, 0};
  float spacing_V = 0.25f;  ///< distance between grid lines; two lines cross at the centre
  Color color{1};
  float opacity = 0.12f;
  Color lineColor{0};
  float lineOpacity = 0.5f;
  float lineWidth_px = 1.5f;
  // Soft shadow of a body on the plane. At a distance of r shadow radii from its centre, the opacity is
  // shadowOpacity·(2^(-2r²) - kShadowEnd), or 0 if that is negative. It is 0 from r = kShadowReach on.
  static constexpr float kShadowEnd = 1.0f / 512, kShadowReach = 2.1213204f;  // sqrt(4.5)
  glm::vec3 shadowCentre_V{0};
  float shadowRadius_V = 0;
  float shadowOpacity = 0;
};

// ---- text: always in front -----------------------------------------------------------------------------------

/// One line of text. `tex` is written in the small TeX subset of text/math_setter.h. `baseline_px` is the left end
/// of the baseline, measured from the picture's top left corner, y down.
struct Text {
  std::string tex;
  glm::vec2 baseline_px{0};
  float size_px = 32;
  Color color{0};
  float opacity = 1;          ///< opacity of glyphs and halo
  std::optional<Color> halo;  ///< colour of a rim around the glyphs, which keeps text legible over lines
  float halo_px = 0;
};

// ---- names: not drawn ----------------------------------------------------------------------------------------

/// Point of the drawing that a figure for LaTeX offers as a coordinate, such as the tip of an arrow. `name` has
/// ASCII letters, digits and hyphens, and does not begin with a digit. Several points may have the same name.
struct NamedPoint {
  std::string name;
  glm::vec3 at_V{0};
};

struct DrawList {
  Camera camera;
  Color background{1};
  glm::vec3 lightDirection_C{-0.5f, 0.72f, 0.48f};  ///< direction to the light, which moves with the camera
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
  std::vector<NamedPoint> points;
  bool isCutOff = false;  ///< whether the camera's zoom or shift leaves out a part of the motion; not drawn
};

static_assert(core::laidOut<Material, 16, 4>() && core::laidOut<Graticule, 24, 4>() &&
              core::laidOut<Ellipsoid, 80, 4>() && core::laidOut<Frustum, 48, 4>() &&
              core::laidOut<Box, 64, 4>() && core::laidOut<GlassEllipsoid, 100, 4>() &&
              core::laidOut<GlassCone, 76, 4>() && core::laidOut<GridPlane, 96, 4>());

}  // namespace poinsot::draw
