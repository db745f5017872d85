// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "geometry/mesh_file.h"
#include "geometry/mesh_integrals.h"
#include "geometry/mesh_samples.h"
#include "geometry/mesh_writers.h"

// A damaged file must be either refused with core::Error or read as a mesh with valid indices, without a crash or
// another exception.

namespace poinsot::geometry {
namespace {

struct File {
  MeshFormat format;
  std::string bytes;
};

std::vector<File> files() {
  std::vector<File> result;
  for (const Mesh& mesh : {cubeMesh(1), torusMesh(1.1, .35, 4)}) {
    result.push_back({MeshFormat::kObj, asObj(mesh)});
    result.push_back({MeshFormat::kStl, asAsciiStl(mesh)});
    result.push_back({MeshFormat::kStl, asBinaryStl(mesh)});
    result.push_back({MeshFormat::kPly, asAsciiPly(mesh)});
    result.push_back({MeshFormat::kPly, asBinaryPly(mesh, std::endian::little)});
    result.push_back({MeshFormat::kPly, asBinaryPly(mesh, std::endian::big)});
  }
  return result;
}

/// Returns whether the bytes were read as a closed mesh.
bool attempt(const std::string& bytes, MeshFormat format) {
  try {
    const Mesh mesh = parseMesh(bytes, format, "damaged").mesh;
    for (const Mesh::Triangle& triangle : mesh.triangles)
      for (const std::uint32_t i : triangle) EXPECT_LT(i, mesh.vertices_M.size());
    checkClosed(mesh);
    return true;
  } catch (const core::Error& error) {
    EXPECT_FALSE(error.message().empty());
    return false;
  }
}

TEST(MeshFuzz, SurvivesEveryTruncation) {
  for (const File& file : files()) {
    EXPECT_TRUE(attempt(file.bytes, file.format));
    for (std::size_t length = 0; length < file.bytes.size(); ++length)
      attempt(file.bytes.substr(0, length), file.format);
    EXPECT_FALSE(attempt(file.bytes.substr(0, file.bytes.size() / 2), file.format));
  }
}

std::string mutated(std::string bytes, Draw& draw) {
  static const std::string_view kPieces[] = {
      "-1",    "4294967295", "9999999999999999999", "nan",  "1e999", "\n",
      "0",     "list",       "\xff\xff\xff\xff",    "f",    "v",     "vertex",
      " \\\n", "end_header", "property uchar x\n",  "solid"};
  for (std::size_t edits = 1 + draw.below(4); edits > 0; --edits) {
    const std::size_t at = draw.below(bytes.size());
    switch (draw.below(4)) {
      case 0:
        bytes[at] = static_cast<char>(draw.below(256));
        break;
      case 1:
        bytes.erase(at, 1 + draw.below(9));
        break;
      case 2:
        bytes.insert(at, kPieces[draw.below(std::size(kPieces))]);
        break;
      default:
        bytes.insert(at, bytes.substr(draw.below(bytes.size()), draw.below(60)));
    }
    if (bytes.empty()) return bytes;
  }
  return bytes;
}

TEST(MeshFuzz, SurvivesRandomDamage) {
  Draw draw(77);
  int read = 0, refused = 0;
  for (const File& file : files())
    for (int i = 0; i < 1500; ++i) ++(attempt(mutated(file.bytes, draw), file.format) ? read : refused);
  EXPECT_GT(read, 300);      // measured 924 of 18000: files that stay closed reach deep into the readers
  EXPECT_GT(refused, 9000);  // measured 17076
}

TEST(MeshFuzz, RejectsOneFormatReadAsAnother) {
  for (const File& file : files())
    for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kStl, MeshFormat::kPly})
      EXPECT_EQ(attempt(file.bytes, format), format == file.format);
}

}  // namespace
}  // namespace poinsot::geometry
