// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/abi.h"
#include "geometry/mesh.h"

namespace poinsot::geometry {

/// Integrals over the inside of a closed surface, in the mesh's axes M. They describe a homogeneous body of mass m
/// completely: mass m, centre `centre_M`, inertia m·inertiaPerMass_M.
struct MeshIntegrals {
  double volume_m3 = 0;
  Eigen::Vector3d centre_M = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertiaPerMass_M = Eigen::Matrix3d::Zero();  ///< about the centre, m² (eq 13); exactly symmetric
};

/// Computes the integrals by the divergence theorem, from the signed tetrahedra between a point and each triangle
/// (a, b, c), with det = a·(b × c):
///   V = Σ det/6,   V centre = Σ det (a + b + c)/24,   ∫r r = Σ det (s s + a a + b b + c c)/120,  s = a + b + c
/// The point is the centre of the bounding box and, in a second pass, the computed centre: a mesh 1e6 of its
/// lengths from the origin keeps its digits. Sums are compensated and of fixed order, so that the bits are the
/// same everywhere.
/// Source: the integrals of r and r r over a tetrahedron; B. Mirtich, J. Graphics Tools 1 (1996) 31.
/// @warning Without meaning for a mesh that is not closed (checkClosed()).
/// @pre at least one vertex; indices in range, coordinates finite.
MeshIntegrals integrals(const Mesh& mesh);

/// Checks that the mesh bounds a volume. Along each edge, as many triangles run one way as the other, so that
/// parts may touch at an edge or a face. Outsides face outward, also of each part that lies in no other, and no
/// triangle is there twice. Triangles with a repeated corner or without area are allowed.
/// @throws core::Error(kScene) otherwise, naming an edge by its ends and a triangle by its place in the file.
/// @pre indices in range, coordinates finite.
void checkClosed(const Mesh& mesh);

static_assert(core::laidOut<MeshIntegrals, 104>());

}  // namespace poinsot::geometry
