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
  kObj,  ///< Wavefront: v and f lines, with polygons and negative indices; ignores other lines
  kStl,  ///< ASCII or binary
  kPly,  ///< ASCII or binary of either byte order; elements vertex (x, y, z) and face (vertex_indices)
};

/// Limits on one mesh file. With the default values, reading a hostile file takes only a few seconds and some
/// hundred MiB.
struct MeshLimits {
  std::size_t bytes = std::size_t{128} << 20;
  std::size_t triangles = 2'000'000;

  std::size_t vertices() const { return 3 * triangles; }
};

/// Returns the format that belongs to the extension .obj, .stl or .ply, in small or capital letters.
/// @throws core::Error(kScene) for any other extension.
MeshFormat meshFormatOf(const std::filesystem::path& path);

struct MeshReading {
  Mesh mesh;
  std::vector<std::string> notes;  ///< messages about joined corners and ignored data, in printable characters
};

/// Reads a mesh from the bytes of a file. Lengths stay as in the file, polygons become fans of triangles from
/// their first corner, and vertices at the same position are welded (mesh.h). If the surface is open only because
/// corners differ by rounding, the corners are joined (mesh_joining.h), with a note. Surplus bytes and numbers are
/// ignored, with a note. The mesh may still be open: to check it, call checkClosed().
/// @param name  names the file in messages and notes
/// @throws core::Error(kScene) if the file cannot be read, with FILE:LINE for a text file or the byte number for a
/// binary file; core::Error(kLimit) beyond the limits.
MeshReading parseMesh(std::string_view bytes, MeshFormat format, const std::string& name,
                      const MeshLimits& limits = {});

/// Reads a regular file, in the format of its extension. @throws core::Error as parseMesh().
MeshReading readMesh(const std::filesystem::path& path, const MeshLimits& limits = {});

}  // namespace poinsot::geometry
