// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace poinsot::geometry {

enum class MeshFormat {
  kObj,  ///< Wavefront: v and f lines, polygons, negative indices; other lines are ignored
  kStl,  ///< ASCII or binary
  kPly,  ///< ASCII or binary of either byte order; elements vertex (x, y, z) and face (vertex_indices)
};

/// Limits on one file, so that a hostile file costs a few seconds and some hundred MiB, not the machine.
struct MeshLimits {
  std::size_t bytes = std::size_t{128} << 20;
  std::size_t triangles = 2'000'000;

  std::size_t vertices() const { return 3 * triangles; }
};

/// Returns the format by the extension .obj, .stl or .ply, in either case. @throws core::Error(kScene) otherwise.
MeshFormat meshFormatOf(const std::filesystem::path& path);

struct MeshReading {
  Mesh mesh;
  std::vector<std::string> notes;  ///< what was joined or ignored, each with FILE:LINE or the byte; printable
};

/// Reads a mesh from the bytes of a file. Polygons become fans of triangles from their first corner, lengths stay
/// as in the file, and vertices at the same place are welded (mesh.h). If the surface is then open, but closes
/// when corners that differ by rounding are joined (1e-9 of the size, else 1e-6), the corners are joined, with a
/// note. Surplus bytes and numbers are ignored, with a note. To check that the mesh is closed, call checkClosed().
/// @param name  names the file in messages and notes
/// @throws core::Error(kScene) with FILE:LINE for a text, or the byte's number for a binary file, if the file
/// cannot be read; core::Error(kLimit) beyond the limits.
MeshReading parseMesh(std::string_view bytes, MeshFormat format, const std::string& name,
                      const MeshLimits& limits = {});

/// Reads a regular file, in the format of its extension. @throws core::Error as parseMesh().
MeshReading readMesh(const std::filesystem::path& path, const MeshLimits& limits = {});

}  // namespace poinsot::geometry
