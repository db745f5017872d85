// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>

#include "core/vector2.h"
#include "geometry/mesh.h"

// Closed meshes whose triangles face outward. Lengths are in m. Solids of revolution have the axis z. On curved
// surfaces, the vertices lie exactly on the surface, and the error of the volume falls as 1/segments².
namespace poinsot::geometry {

/// Point of a plane outline, in m. (A std::vector<Eigen::Vector2d> does not convert to std::span<const Vector2>.)
using core::Vector2;

/// Returns the solid of revolution of a polygon, which turns about z in `segments` steps. The polygon lies in the
/// half plane (r, z) with r >= 0. Its corners are counter-clockwise, and an edge from the last corner to the first
/// closes it. A corner on the axis (r = 0) becomes a single vertex.
/// @pre segments >= 3, three corners or more, none with r < 0.
Mesh turnedMesh(std::span<const Vector2> outline_rz, int segments);

/// Returns a prism: a counter-clockwise polygon in the xy plane, extruded from z = -thickness/2 to +thickness/2.
/// @pre three corners or more; the first one sees every other.
Mesh prismMesh(std::span<const Vector2> outline_xy, double thickness_m);

/// Returns a box with edges along the axes, centred at the origin.
Mesh boxMesh(const Eigen::Vector3d& edges_m);

/// Returns an ellipsoid. The faces of an icosahedron are split into four, `subdivisions` times, and all vertices
/// are moved to the surface of the ellipsoid.
/// @pre 0 <= subdivisions <= 8.
Mesh ellipsoidMesh(const Eigen::Vector3d& semiAxes_m, int subdivisions);

/// Returns a torus. The centre line of its tube is a circle of radius_m in the xy plane. The centre line and the
/// cross-section of the tube have `segments` segments each.
/// @pre 0 < tubeRadius_m < radius_m.
Mesh torusMesh(double radius_m, double tubeRadius_m, int segments);

/// Returns a half ball, with the centre of its flat face at the origin and its dome towards +z.
Mesh hemisphereMesh(double radius_m, int segments);

/// Returns a frustum (truncated cone) between circles of the two radii, at z = low_m and z = high_m. If one radius
/// is 0, the solid is a cone.
/// @pre low_m < high_m; not both radii 0.
Mesh frustumMesh(double lowRadius_m, double highRadius_m, double low_m, double high_m, int segments);

/// Returns a cylinder with a hole along its axis, centred at the origin. @pre 0 < innerRadius_m < radius_m.
Mesh tubeMesh(double radius_m, double innerRadius_m, double height_m, int segments);

/// Returns a capsule: a cylinder of height_m with half balls on its ends, centred at the origin.
Mesh capsuleMesh(double radius_m, double height_m, int segments);

/// Returns an L-shaped prism with its outer corner at x = y = 0. Its two arms, of width arm_m, lie along +x and
/// +y, and edges_m are their outer lengths. The thickness extends along z, as in prismMesh().
/// @pre 0 < arm_m < both edges.
Mesh lPrismMesh(const Vector2& edges_m, double arm_m, double thickness_m);

// Regular polyhedra, centred at the origin.
Mesh tetrahedronMesh(double edge_m);
Mesh cubeMesh(double edge_m);
Mesh octahedronMesh(double edge_m);
Mesh dodecahedronMesh(double edge_m);
Mesh icosahedronMesh(double edge_m);

}  // namespace poinsot::geometry
