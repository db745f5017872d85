// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>

#include "core/vector2.h"
#include "geometry/mesh.h"

// Closed meshes with their outside outward. Lengths in m; solids of revolution are about z. Curved surfaces are
// inscribed: their vertices lie on the true surface, and the error of their volume falls as 1/segments².
namespace poinsot::geometry {

/// Point of a plane, in m. A std::vector<Eigen::Vector2d> does not convert to a span of these points.
using core::Vector2;

/// Returns the solid swept by a polygon in the half plane (r, z), r >= 0, that turns about z in `segments` steps.
/// The polygon is counter-clockwise, and an edge from its last corner to its first closes it. Corners on the axis
/// (r = 0) become one vertex, and an edge along the axis sweeps nothing.
/// @pre segments >= 3, three corners or more, none with r < 0.
Mesh turnedMesh(std::span<const Vector2> outline_rz, int segments);

/// Returns a prism: a counter-clockwise polygon in the xy plane, thickened from z = -thickness/2 to +thickness/2.
/// @pre three corners or more; the first one sees every other.
Mesh prismMesh(std::span<const Vector2> outline_xy, double thickness_m);

/// Returns a box with edges along the axes, centred at the origin.
Mesh boxMesh(const Eigen::Vector3d& edges_m);

/// Returns an ellipsoid: an icosahedron whose faces are split in four `subdivisions` times, with vertices moved
/// out to the surface.
/// @pre 0 <= subdivisions <= 8.
Mesh ellipsoidMesh(const Eigen::Vector3d& semiAxes_m, int subdivisions);

/// Returns a torus: a tube round the circle of radius_m in the xy plane, with as many segments as the circle.
/// @pre 0 < tubeRadius_m < radius_m.
Mesh torusMesh(double radius_m, double tubeRadius_m, int segments);

/// Returns a half ball, with the centre of its flat face at the origin and its dome towards +z.
Mesh hemisphereMesh(double radius_m, int segments);

/// Returns a frustum between circles of the two radii at z = low_m and high_m. A radius of 0 is an apex.
/// @pre low_m < high_m; not both radii 0.
Mesh frustumMesh(double lowRadius_m, double highRadius_m, double low_m, double high_m, int segments);

/// Returns a cylinder with a hole along its axis, centred at the origin. @pre 0 < innerRadius_m < radius_m.
Mesh tubeMesh(double radius_m, double innerRadius_m, double height_m, int segments);

/// Returns a cylinder of height_m with half balls on its ends, centred at the origin.
Mesh capsuleMesh(double radius_m, double height_m, int segments);

/// Returns a prism of two arms along +x and +y, with its outer corner at the origin, in the xy plane, thickened as
/// by prismMesh().
/// @pre 0 < arm_m < both edges.
Mesh lPrismMesh(const Vector2& edges_m, double arm_m, double thickness_m);

// Regular polyhedra, centred at the origin.
Mesh tetrahedronMesh(double edge_m);
Mesh cubeMesh(double edge_m);
Mesh octahedronMesh(double edge_m);
Mesh dodecahedronMesh(double edge_m);
Mesh icosahedronMesh(double edge_m);

}  // namespace poinsot::geometry
