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

TEST(MeshCheck, AnOpenMeshNamesTheEdge) {
  Mesh mesh = boxMesh({2, 4, 6});
  mesh.triangles.pop_back();  // half of the face z = -3
  EXPECT_EQ(verdict(mesh),
            "the mesh is open at the edge from (1, 2, -3) to (-1, 2, -3); only a closed surface has a volume");
  EXPECT_EQ(verdict(Mesh{}), "the mesh has no triangles");
}

TEST(MeshCheck, EveryMissingTriangleIsFound) {
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

TEST(MeshCheck, ATriangleFacingInwardNamesTheEdge) {
  Mesh mesh = boxMesh({2, 4, 6});
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  EXPECT_EQ(verdict(mesh),
            "two neighbouring triangles of the mesh run the same way along the edge from (1, 2, 3) to (1, -2, 3); "
            "one of them faces inward");
}

TEST(MeshCheck, InsideOutIsRefusedWithTheRepair) {
  EXPECT_EQ(verdict(flipped(boxMesh({2, 4, 6}))),
            "the mesh is inside out: its volume is -48 m³; flip its triangles (swap two corners of each)");
}

TEST(MeshCheck, FourTrianglesAtAnEdge) {
  const Mesh two = welded(joined(cubeMesh(1), transformed(cubeMesh(1), Eigen::Matrix3d::Identity(), {1, 1, 0})));
  EXPECT_EQ(
      verdict(two),
      "more than two triangles of the mesh meet at the edge from (0.5, 0.5, 0.5) to (0.5, 0.5, -0.5); a body's "
      "surface has two at every edge");
}

TEST(MeshCheck, AFoldedSheetHasNoVolume) {
  Mesh sheet;
  sheet.vertices_M = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.3, .7, 0}};
  sheet.triangles = {{0, 1, 3}, {0, 3, 2}, {0, 3, 1}, {0, 2, 3}};
  EXPECT_NE(verdict(sheet), "accepted");
  sheet.triangles = {{0, 1, 2}, {0, 2, 1}};
  EXPECT_EQ(verdict(sheet), "the mesh encloses no volume");
}

TEST(MeshCheck, TrianglesWithoutAreaDoNoHarm) {
  Mesh mesh = cubeMesh(1);
  const auto [a, b, c] = mesh.triangles[0];
  mesh.triangles.push_back({a, a, b});  // a corner repeated
  // A new vertex on an edge, with a sliver that fills the crack it makes.
  const auto middle = static_cast<std::uint32_t>(mesh.vertices_M.size());
  mesh.vertices_M.push_back((mesh.vertices_M[a] + mesh.vertices_M[b]) / 2);
  mesh.triangles[0] = {a, middle, c};
  mesh.triangles.push_back({middle, b, c});
  mesh.triangles.push_back({a, b, middle});
  EXPECT_EQ(verdict(mesh), "accepted");
  EXPECT_NEAR(integrals(mesh).volume_m3, 1, 1e-15);
}

TEST(MeshCheck, ACavityIsAMeshInsideOut) {
  EXPECT_EQ(verdict(joined(boxMesh({1.2, .9, .5}), flipped(boxMesh({1.1, .8, .4})))), "accepted");
}

TEST(MeshCheck, IndicesAreAContract) {
  Mesh mesh = cubeMesh(1);
  mesh.triangles[3][1] = 8;
  EXPECT_THROW(checkClosed(mesh), std::logic_error);
}

TEST(Mesh, WeldingSharesCornersAndDropsStrays) {
  Mesh soup;  // as an STL file has it, with a stray vertex
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
  EXPECT_EQ(mesh.vertices_M[0], soup.vertices_M[1]);  // in the order of the first
}

TEST(Mesh, WeldingKnowsNoSignOfZero) {
  Mesh mesh{{{0., 1, 0}, {1, 0, 0}, {0, 0, 1}, {-0., 1, 0}}, {{0, 1, 2}, {3, 2, 1}}};
  EXPECT_EQ(welded(mesh).vertices_M.size(), 3U);
}

}  // namespace
}  // namespace poinsot::geometry
