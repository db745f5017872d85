// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <string>

#include "geometry/mesh.h"

namespace poinsot::geometry {

// A mesh as the bytes of a file: what other programs write, for the readers to read. Numbers to 17 digits in the
// texts, floats in binary STL.

std::string asObj(const Mesh& mesh);
std::string asAsciiStl(const Mesh& mesh);
std::string asBinaryStl(const Mesh& mesh);
std::string asAsciiPly(const Mesh& mesh);
/// With properties and an element that the reader must step over.
std::string asBinaryPly(const Mesh& mesh, std::endian order);

}  // namespace poinsot::geometry
