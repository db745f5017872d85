// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <string>

#include "geometry/mesh.h"

namespace poinsot::geometry {

// Writers of meshes as files of other programs. Texts have 17 digits, binary STL has floats.

std::string asObj(const Mesh& mesh);
std::string asAsciiStl(const Mesh& mesh);
std::string asBinaryStl(const Mesh& mesh);
std::string asAsciiPly(const Mesh& mesh);
/// Writes a binary PLY with properties and an element that the reader must skip.
std::string asBinaryPly(const Mesh& mesh, std::endian order);

}  // namespace poinsot::geometry
