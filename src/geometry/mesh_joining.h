// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "geometry/mesh.h"

namespace poinsot::geometry {

struct JoinedMesh {
  Mesh mesh;
  std::size_t corners = 0;  ///< number of corners that were moved onto another corner
  double farthest = 0;      ///< distance of the longest move, in the mesh's unit
  double size = 0;          ///< largest extent of the mesh, in the mesh's unit
};

/// Closes a surface that is open because its corners differ by rounding. Joins neighbouring corners at open edges
/// if they are within 1e-9 of the mesh's largest extent, or, if the surface is then still open, within 1e-6.
/// Removes the triangles that collapse. Corners away from open edges do not move, so that no small detail is lost.
/// Returns nullopt if the surface is already closed, or cannot be closed in this way.
///
/// Reason for 1e-9: coordinates that programs compute in doubles differ by about 1e-15 of the size (at most
/// 1.6e-15 in the meshes of the trimesh repository). No modelled detail is as small as a billionth of the model.
/// Reason for 1e-6: programs that compute in floats round a coordinate by 6e-8, several times in succession.
std::optional<JoinedMesh> closedByJoining(const Mesh& mesh);

}  // namespace poinsot::geometry
