// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "geometry/mesh.h"

// Internal to this layer.
namespace poinsot::geometry {

/// A mesh whose corners were joined, and what that took.
struct JoinedMesh {
  Mesh mesh;
  std::size_t corners = 0;  ///< how many were moved onto another
  double farthest = 0;      ///< the longest of these moves, in the mesh's unit
  double size = 0;          ///< largest extent of the mesh, in its unit
};

/// Closes a surface whose corners differ by rounding: joins corners at its open edges that are next to each other,
/// within 1e-9 of its largest extent, else within 1e-6, and removes the triangles that collapse. Corners elsewhere
/// stay, so that no detail is lost, however small. Returns nothing for a surface that is closed without it, and
/// for one that joining does not close.
///
/// Why 1e-9: programs that compute in doubles differ by some 1e-15 of the size where they write 0 or an
/// intersection (1.6e-15 is the most in the meshes of the trimesh repository), and a part of a billionth of its
/// assembly is not modelled. Why 1e-6: programs that compute in floats round by 6e-8 of a coordinate, several
/// times over.
std::optional<JoinedMesh> closedByJoining(const Mesh& mesh);

}  // namespace poinsot::geometry
