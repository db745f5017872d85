// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "geometry/mesh.h"

namespace poinsot::geometry {

struct JoinedMesh {
  Mesh mesh;
  std::size_t corners = 0;  ///< number of corners moved onto another
  double farthest = 0;      ///< the longest move, in the mesh's unit
  double size = 0;          ///< largest extent of the mesh, in its unit
};

/// Closes a surface whose corners differ by rounding. Joins neighbouring corners at its open edges, within 1e-9 of
/// its largest extent, else within 1e-6, and removes the triangles that collapse. Other corners stay, so that no
/// detail is lost, however small. Returns nullopt if the surface is already closed, or cannot be closed this way.
///
/// Reason for 1e-9: programs that compute in doubles differ by some 1e-15 of the size where they write 0 or an
/// intersection (1.6e-15 is the most in the meshes of the trimesh repository), and nobody models a part of a
/// billionth of its assembly. Reason for 1e-6: programs that compute in floats round by 6e-8 of a coordinate,
/// several times over.
std::optional<JoinedMesh> closedByJoining(const Mesh& mesh);

}  // namespace poinsot::geometry
