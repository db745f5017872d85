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
  kObj,  ///< Wavefront: v and f lines, polygons, negative indices; the rest is passed over
  kStl,  ///< ASCII or binary
  kPly,  ///< ASCII or binary of either byte order; elements vertex (x, y, z) and face (vertex_indices)
};

/// Limits on one file, so that a hostile one costs a few seconds and some hundred MiB, not the machine.
struct MeshLimits {
  std::size_t bytes = std::size_t{128} << 20;
  std::size_t triangles = 2'000'000;

  std::size_t vertices() const { return 3 * triangles; }
};

/// By the ending .obj, .stl or .ply, in any case. @throws core::Error(kScene) for any other.
MeshFormat meshFormatOf(const std::filesystem::path& path);

/// A mesh as it was read, and what a user should know of its file.
struct MeshReading {
  Mesh mesh;
  std::vector<std::string> notes;  ///< what was joined or passed over, each with FILE:LINE or the byte; printable
};

/// Reads a mesh from its file's bytes: polygons become fans of triangles from their first corner, lengths stay as
/// the file has them, vertices at the same place are welded (mesh.h). If the surface is open then and closes when
/// corners that differ by rounding are joined (1e-9 of the size, else 1e-6), they are joined, with a note. Surplus
/// bytes and numbers are passed over, with a note. checkClosed() checks that the mesh is closed.
/// @param name  names the file in messages and notes
/// @throws core::Error(kScene) with FILE:LINE for a text and the byte's number for a binary, where it cannot be
/// read; core::Error(kLimit) beyond the limits.
MeshReading parseMesh(std::string_view bytes, MeshFormat format, const std::string& name,
                      const MeshLimits& limits = {});

/// Reads a regular file, its format by its ending. @throws as parseMesh.
MeshReading readMesh(const std::filesystem::path& path, const MeshLimits& limits = {});

}  // namespace poinsot::geometry
