// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>

#include "core/vector2.h"
#include "geometry/mesh.h"

// Closed meshes, outside outward. Lengths in m; solids of revolution are about z. Curved surfaces are inscribed:
// their vertices lie on the true surface, and their volume grows to the true one as 1/segments².
namespace poinsot::geometry {

/// A point of a plane, m. A std::vector<Eigen::Vector2d> is no span of it.
using core::Vector2;

/// The solid swept by a polygon in the half plane (r, z), r >= 0, turning about z in `segments` steps. The polygon
/// is closed by its last corner to its first, counter-clockwise; corners on the axis (r = 0) become one vertex,
/// and an edge along the axis sweeps nothing.
/// @pre segments >= 3, three corners or more, none with r < 0.
Mesh turnedMesh(std::span<const Vector2> outline_rz, int segments);

/// A polygon in the xy plane, counter-clockwise, thickened from z = -thickness/2 to +thickness/2.
/// @pre three corners or more; the first one sees every other.
Mesh prismMesh(std::span<const Vector2> outline_xy, double thickness_m);

/// Edges along the axes, centred at the origin.
Mesh boxMesh(const Eigen::Vector3d& edges_m);

/// An ellipsoid as an icosahedron whose 20 faces are split in four `subdivisions` times, vertices on the surface.
/// @pre 0 <= subdivisions <= 8.
Mesh ellipsoidMesh(const Eigen::Vector3d& semiAxes_m, int subdivisions);

/// The circle of radius_m in the xy plane with a tube round it, as many segments round the tube as round the
/// circle. @pre 0 < tubeRadius_m < radius_m.
Mesh torusMesh(double radius_m, double tubeRadius_m, int segments);

/// Centre of the flat face at the origin, dome towards +z.
Mesh hemisphereMesh(double radius_m, int segments);

/// Circles of the two radii at z = low_m and high_m; a radius of 0 is an apex.
/// @pre low_m < high_m; not both radii 0.
Mesh frustumMesh(double lowRadius_m, double highRadius_m, double low_m, double high_m, int segments);

/// A cylinder with a hole along its axis, centred at the origin. @pre 0 < innerRadius_m < radius_m.
Mesh tubeMesh(double radius_m, double innerRadius_m, double height_m, int segments);

/// A cylinder of height_m with half balls on its ends, centred at the origin.
Mesh capsuleMesh(double radius_m, double height_m, int segments);

/// Two arms along +x and +y, outer corner at the origin, in the xy plane, thickened as a prism.
/// @pre 0 < arm_m < both edges.
Mesh lPrismMesh(const Vector2& edges_m, double arm_m, double thickness_m);

// Regular polyhedra, centred at the origin.
Mesh tetrahedronMesh(double edge_m);
Mesh cubeMesh(double edge_m);
Mesh octahedronMesh(double edge_m);
Mesh dodecahedronMesh(double edge_m);
Mesh icosahedronMesh(double edge_m);

}  // namespace poinsot::geometry
