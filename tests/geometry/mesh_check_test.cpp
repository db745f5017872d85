// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "geometry/mesh_integrals.h"
#include "geometry/mesh_samples.h"

namespace poinsot::geometry {
namespace {

using Eigen::Vector3d;

std::string verdict(const Mesh& mesh) {
  return refusal([&] { checkClosed(mesh); });
}

TEST(MeshCheck, NamesTheOpenEdgeOfAMesh) {
  Mesh mesh = boxMesh({2, 4, 6});
  mesh.triangles.pop_back();  // half of the face z = -3
  EXPECT_EQ(verdict(mesh),
            "the mesh is open at the edge from (1, 2, -3) to (-1, 2, -3); only a closed surface has a volume: "
            "close the hole in a mesh program");
  EXPECT_EQ(verdict(Mesh{}), "the mesh has no triangles; a body is bounded by triangles");
}

TEST(MeshCheck, FindsEveryMissingOrFlippedTriangle) {
  for (const Sample& sample : primitives(7))
    for (std::size_t i = 0; i < sample.mesh.triangles.size(); ++i) {
      Mesh open = sample.mesh;
      open.triangles.erase(open.triangles.begin() + static_cast<std::ptrdiff_t>(i));
      EXPECT_NE(verdict(open), "accepted") << sample.name;
      Mesh mixed = sample.mesh;
      std::swap(mixed.triangles[i][0], mixed.triangles[i][1]);
      EXPECT_NE(verdict(mixed), "accepted") << sample.name;
    }
}

TEST(MeshCheck, NamesTheEdgeOfATriangleFacingInward) {
  Mesh mesh = boxMesh({2, 4, 6});
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  EXPECT_EQ(verdict(mesh),
            "two neighbouring triangles of the mesh run the same way along the edge from (1, 2, 3) to (1, -2, 3); "
            "one of them faces inward: swap two of its corners");
}

TEST(MeshCheck, RejectsAMeshThatIsInsideOut) {
  EXPECT_EQ(verdict(flipped(boxMesh({2, 4, 6}))),
            "the mesh is inside out: its volume is -48 m³; flip its triangles (swap two corners of each)");
}

Mesh moved(Mesh mesh, const Vector3d& by) { return transformed(std::move(mesh), Eigen::Matrix3d::Identity(), by); }

// A cube of mass 1 has the moment 1/6 about its centre. Each cube's centre is (±1/2, ±1/2, 0) from the common one.
TEST(MeshCheck, AcceptsFourTrianglesAtAnEdge) {
  const Mesh two = welded(joined(cubeMesh(1), moved(cubeMesh(1), {1, 1, 0})));
  EXPECT_EQ(two.vertices_M.size(), 14U);  // the cubes share two corners
  EXPECT_EQ(verdict(two), "accepted");
  Eigen::Matrix3d expected = Vector3d(1. / 6 + 1. / 4, 1. / 6 + 1. / 4, 1. / 6 + 1. / 2).asDiagonal();
  expected(0, 1) = expected(1, 0) = -1. / 4;
  const MeshIntegrals both = integrals(two);
  EXPECT_NEAR(both.volume_m3, 2, 1e-15);                                       // measured 0
  EXPECT_LE((both.centre_M - Vector3d(.5, .5, 0)).norm(), 1e-15);              // measured 0
  EXPECT_LE((both.inertiaPerMass_M - expected).cwiseAbs().maxCoeff(), 1e-15);  // measured 1.1e-16
}

TEST(MeshCheck, AcceptsPartsThatShareAFace) {
  const Mesh two = welded(joined(cubeMesh(1), moved(cubeMesh(1), {1, 0, 0})));
  EXPECT_EQ(two.vertices_M.size(), 12U);
  EXPECT_EQ(verdict(two), "accepted");
  const Mesh box = boxMesh({2, 1, 1});
  EXPECT_LE((integrals(two).inertiaPerMass_M - integrals(box).inertiaPerMass_M).cwiseAbs().maxCoeff(),
            1e-15);  // measured 1.1e-16
}

TEST(MeshCheck, AcceptsATetrahedronThatTouchesAnotherAtAnEdge) {
  Mesh mesh{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {}};
  for (const auto& [c, d] : {std::pair{2U, 3U}, std::pair{4U, 5U}})
    for (const Mesh::Triangle& t :
         {Mesh::Triangle{0, d, c}, Mesh::Triangle{0, c, 1}, Mesh::Triangle{1, c, d}, Mesh::Triangle{0, 1, d}})
      mesh.triangles.push_back(t);
  EXPECT_EQ(verdict(mesh), "accepted");
  EXPECT_NEAR(integrals(mesh).volume_m3, 1. / 3, 1e-16);  // measured 0
}

TEST(MeshCheck, RejectsATriangleThatSticksOut) {
  Mesh mesh = cubeMesh(1);
  const auto [a, b, c] = mesh.triangles[0];
  const auto tip = static_cast<std::uint32_t>(mesh.vertices_M.size());
  mesh.vertices_M.emplace_back(2, 2, 2);
  mesh.triangles.push_back({a, b, tip});
  EXPECT_NE(verdict(mesh), "accepted");
  mesh.triangles.push_back({b, a, tip});  // a fin with two sides bounds nothing
  EXPECT_EQ(verdict(mesh), "accepted");
  EXPECT_NEAR(integrals(mesh).volume_m3, 1, 1e-15);  // measured 0
}

TEST(MeshCheck, NamesAnEdgeWhoseTrianglesDoNotPairUp) {
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}},
            {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {1, 2, 0}, {2, 0, 1}}};
  EXPECT_EQ(verdict(mesh),
            "the mesh has the triangle (0, 0, 0), (1, 0, 0), (0, 1, 0) more than once; remove all but one");
  mesh.triangles.resize(3);
  EXPECT_EQ(
      verdict(mesh),
      "2 triangles of the mesh run one way along the edge from (0, 0, 0) to (1, 0, 0) and 1 the other way; a "
      "closed surface has as many of each: remove a triangle, or add what is missing, in a mesh program");
}

TEST(MeshCheck, RejectsADuplicatedSurface) {
  const Mesh twice = welded(joined(cubeMesh(1), cubeMesh(1)));  // every edge is balanced
  EXPECT_EQ(verdict(twice).substr(0, 29), "the mesh has the triangle (0.");
  EXPECT_TRUE(verdict(twice).ends_with(") more than once; remove all but one")) << verdict(twice);
  Mesh cancelled = twice;  // a third time, inside out
  for (const auto& [a, b, c] : cubeMesh(1).triangles) cancelled.triangles.push_back({c, b, a});
  EXPECT_EQ(verdict(cancelled), "accepted");
}

TEST(MeshCheck, NamesTheLineOrByteOfTheFaultyTriangle) {
  Mesh mesh = tetrahedronMesh(1);
  for (std::uint64_t line = 10; line < 14; ++line) mesh.places.push_back(atLine(line));
  Mesh open = mesh;
  open.triangles.erase(open.triangles.begin());
  open.places.erase(open.places.begin());
  EXPECT_NE(verdict(open).find(" (of the triangle at line 1"), std::string::npos) << verdict(open);
  Mesh twice = mesh;
  twice.triangles.push_back(twice.triangles[1]);
  twice.places.push_back(atByte(684));
  EXPECT_NE(verdict(twice).find(" more than once (at line 11 and byte 684);"), std::string::npos)
      << verdict(twice);
  std::swap(mesh.triangles[2][0], mesh.triangles[2][1]);
  EXPECT_NE(verdict(mesh).find("line 12"), std::string::npos) << verdict(mesh);
}

TEST(MeshCheck, RejectsAFoldedSheetWithoutVolume) {
  Mesh sheet;
  sheet.vertices_M = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.3, .7, 0}};
  sheet.triangles = {{0, 1, 3}, {0, 3, 2}, {0, 3, 1}, {0, 2, 3}};
  EXPECT_NE(verdict(sheet), "accepted");
  sheet.triangles = {{0, 1, 2}, {0, 2, 1}};
  EXPECT_EQ(
      verdict(sheet),
      "the volume of the mesh is 0: its triangles lie in one plane, or each faces another at the same place; "
      "remove the triangles that face inward, or give the surface a thickness");
}

TEST(MeshCheck, AcceptsTrianglesWithoutArea) {
  Mesh mesh = cubeMesh(1);
  const auto [a, b, c] = mesh.triangles[0];
  mesh.triangles.push_back({a, a, b});  // a corner repeated
  // Adds a vertex on an edge, and a sliver that fills the crack.
  const auto middle = static_cast<std::uint32_t>(mesh.vertices_M.size());
  mesh.vertices_M.push_back((mesh.vertices_M[a] + mesh.vertices_M[b]) / 2);
  mesh.triangles[0] = {a, middle, c};
  mesh.triangles.push_back({middle, b, c});
  mesh.triangles.push_back({a, b, middle});
  EXPECT_EQ(verdict(mesh), "accepted");
  EXPECT_NEAR(integrals(mesh).volume_m3, 1, 1e-15);
}

TEST(MeshCheck, AcceptsACavity) {
  EXPECT_EQ(verdict(joined(boxMesh({1.2, .9, .5}), flipped(boxMesh({1.1, .8, .4})))), "accepted");
}

TEST(MeshCheck, RejectsAVolumeBeyondTheRangeOfADouble) {
  EXPECT_EQ(verdict(cubeMesh(1e110)),
            "the volume of the mesh is beyond the range of a double; give its lengths in a larger unit");
}

TEST(MeshCheck, ThrowsALogicErrorForIndicesOutOfRange) {
  Mesh mesh = cubeMesh(1);
  mesh.triangles[3][1] = 8;
  EXPECT_THROW(checkClosed(mesh), std::logic_error);
}

TEST(Mesh, WeldingMergesCornersAndDropsUnusedVertices) {
  Mesh soup;  // triangles with separate corners, as in an STL file, and a stray vertex
  const Mesh cube = cubeMesh(1);
  soup.vertices_M.emplace_back(9, 9, 9);
  for (const Mesh::Triangle& t : cube.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.vertices_M.size());
    for (const std::uint32_t i : t) soup.vertices_M.push_back(cube.vertices_M[i]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  soup.vertices_M[5][0] += 0.0;
  EXPECT_NE(verdict(soup), "accepted");
  const Mesh mesh = welded(soup);
  EXPECT_EQ(mesh.vertices_M.size(), 8U);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_EQ(verdict(mesh), "accepted");
  EXPECT_EQ(mesh.vertices_M[0], soup.vertices_M[1]);  // ordered by first use
}

TEST(Mesh, WeldingIgnoresTheSignOfZero) {
  Mesh mesh{{{0., 1, 0}, {1, 0, 0}, {0, 0, 1}, {-0., 1, 0}}, {{0, 1, 2}, {3, 2, 1}}};
  EXPECT_EQ(welded(mesh).vertices_M.size(), 3U);
}

}  // namespace
}  // namespace poinsot::geometry
