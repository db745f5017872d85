// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/abi.h"
#include "geometry/mesh.h"

namespace poinsot::geometry {

/// Volume, centre and inertia of the space inside a closed surface, in the mesh's axes M. If a homogeneous body of
/// mass m fills this space, its inertia is m·inertiaPerMass_M.
struct MeshIntegrals {
  double volume_m3 = 0;
  Eigen::Vector3d centre_M = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertiaPerMass_M = Eigen::Matrix3d::Zero();  ///< about the centre, m² (eq 13); exactly symmetric
};

/// Computes volume, centre and inertia by the divergence theorem. Each triangle (a, b, c) forms a tetrahedron with
/// a common reference point. The sums run over all tetrahedra; a, b and c are measured from the reference point,
/// and det = a·(b × c):
///   V = Σ det/6,   V centre = Σ det (a + b + c)/24,   ∫r r = Σ det (s s + a a + b b + c c)/120,  s = a + b + c
/// The reference point is the centre of the bounding box and, in a second pass, the computed centre. A mesh that
/// is 1e6 of its lengths away from the origin therefore loses no digits. The sums are compensated and have a fixed
/// order, so that every machine computes the same bits.
/// Source: the integrals of r and r r over a tetrahedron; B. Mirtich, J. Graphics Tools 1 (1996) 31.
/// @warning The result is meaningless for a mesh that is not closed (checkClosed()).
/// @pre at least one vertex; indices in range, coordinates finite.
MeshIntegrals integrals(const Mesh& mesh);

/// Checks that the mesh bounds a volume. Along each edge, as many triangles must run one way as the other. The
/// mesh, and each part of it that is not a cavity, must face outward. No triangle may occur twice. Parts may touch
/// at an edge or a face. Triangles with a repeated corner or without area are allowed.
/// @throws core::Error(kScene) otherwise, naming an edge by its ends and a triangle by its position in the file.
/// @pre indices in range, coordinates finite.
void checkClosed(const Mesh& mesh);

static_assert(core::laidOut<MeshIntegrals, 104>());

}  // namespace poinsot::geometry
