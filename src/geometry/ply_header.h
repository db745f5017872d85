// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh_readers.h"

namespace poinsot::geometry {

enum class PlyScalar { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

inline bool isWhole(PlyScalar type) { return type != PlyScalar::kFloat32 && type != PlyScalar::kFloat64; }

/// Property of an element. Each row of the element has one number, or a list: a count followed by as many numbers.
struct PlyProperty {
  std::string name;
  PlyScalar type = PlyScalar::kFloat32;
  std::optional<PlyScalar> countType;  ///< type of a list's count; nullopt if the property is not a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  FilePlace place;
};

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
};

/// Reads the header. Afterwards, `lines` is at the last line of the header, end_header.
PlyHeader readPlyHeader(LineReader& lines, const MeshBuilder& builder);

}  // namespace poinsot::geometry
