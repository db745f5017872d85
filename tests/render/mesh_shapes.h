// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "draw/draw_list.h"

/// Closed meshes of known shape, counter-clockwise from outside.
namespace poinsot::render {

using MeshPointer = std::shared_ptr<const draw::TriangleMesh>;

/// Corners at (±1, ±1, ±1).
MeshPointer cube();
/// Four of the cube's corners.
MeshPointer tetrahedron();
/// Corners on the unit sphere; `subdivisions` times each triangle is cut in four, the new corners put on the
/// sphere.
MeshPointer icosphere(int subdivisions);
/// An icosphere whose corners are up to `depth` nearer the centre, by chance.
MeshPointer roughSphere(int subdivisions, float depth);
/// Axis z; the tube's middle has radius 1.
MeshPointer torus(float tubeRadius, int around, int along);
/// An L of thickness 1 in z with arms 2 long and 1 wide; its hollow edge is at the origin.
MeshPointer lPrism();
/// Two cubes with edges of 1 that share the edge along z, so that four faces meet at it. The triangles of the two
/// alternate.
MeshPointer cubesAtAnEdge();
/// The half z >= 0 of the unit sphere, closed by a disc.
MeshPointer hemisphere(int around, int along);

}  // namespace poinsot::render
