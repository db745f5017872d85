// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/mesh.h"

namespace poinsot::geometry {

enum class MeshFormat {
  kObj,  ///< Wavefront: v and f lines, polygons, negative indices; the rest is passed over
  kStl,  ///< ASCII or binary
  kPly,  ///< ASCII or binary of either byte order; elements vertex (x, y, z) and face (vertex_indices)
};

/// Limits on one file, so that a hostile one costs a second and a few hundred MiB, not the machine.
struct MeshLimits {
  std::size_t bytes = std::size_t{128} << 20;
  std::size_t triangles = 2'000'000;

  std::size_t vertices() const { return 3 * triangles; }
};

/// By the ending .obj, .stl or .ply, in any case. @throws core::Error(kScene) for any other.
MeshFormat meshFormatOf(const std::filesystem::path& path);

/// A mesh as its file's bytes have it: polygons as fans of triangles from their first corner, vertices at the same
/// place welded (mesh.h), lengths as they stand. Whether it is closed is checkClosed()'s question.
/// @throws core::Error(kScene) with FILE:LINE for a text and the byte's number for a binary, where it cannot be
/// read; core::Error(kLimit) beyond the limits. `name` names the file in messages.
Mesh parseMesh(std::string_view bytes, MeshFormat format, const std::string& name, const MeshLimits& limits = {});

/// Of a regular file, its format by its ending. @throws as parseMesh.
Mesh readMesh(const std::filesystem::path& path, const MeshLimits& limits = {});

}  // namespace poinsot::geometry
