// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "draw/draw_list.h"

/// Closed meshes of known shape, whose triangles are counter-clockwise from outside.
namespace poinsot::render {

using MeshPointer = std::shared_ptr<const draw::TriangleMesh>;

/// Returns a cube with corners at (±1, ±1, ±1).
MeshPointer cube();
/// Returns a tetrahedron of four of the cube's corners.
MeshPointer tetrahedron();
/// Returns a mesh with corners on the unit sphere, whose triangles are cut in four `subdivisions` times.
MeshPointer icosphere(int subdivisions);
/// Returns an icosphere whose corners are moved towards the centre by random lengths of at most `depth`.
MeshPointer roughSphere(int subdivisions, float depth);
/// Returns a torus about z; the tube's centre line has radius 1.
MeshPointer torus(float tubeRadius, int around, int along);
/// Returns an L of thickness 1 in z with arms 2 long and 1 wide; its concave edge is at the origin.
MeshPointer lPrism();
/// Returns two cubes with edges of 1 that share an edge along z, where four faces meet. The cubes' triangles
/// alternate.
MeshPointer cubesAtAnEdge();
/// Returns the half z >= 0 of the unit sphere, closed by a disc.
MeshPointer hemisphere(int around, int along);

}  // namespace poinsot::render
