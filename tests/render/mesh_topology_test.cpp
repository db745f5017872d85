// SPDX-License-Identifier: Apache-2.0
#include "render/mesh_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "mesh_shapes.h"

namespace poinsot::render {
namespace {

std::size_t sharpEdges(const MeshTopology& topology) {
  return static_cast<std::size_t>(
      std::count_if(topology.edges.begin(), topology.edges.end(), [](const MeshEdge& e) { return e.sharp; }));
}

TEST(MeshTopology, ACubeHasTwelveCreasesAndThreeNormalsToACorner) {
  const MeshTopology topology = meshTopology(*cube(), 0.6f);
  EXPECT_EQ(topology.edges.size(), 18);  // 8 - 18 + 12 = 2: twelve edges and six diagonals
  EXPECT_EQ(sharpEdges(topology), 12);
  EXPECT_EQ(topology.chains.size(), 12);  // three meet at every corner, so that no chain goes on
  EXPECT_EQ(topology.corners.size(), 24);
  for (const MeshCorner& c : topology.corners) {
    const glm::vec3 n = glm::abs(c.normal_M);
    EXPECT_FLOAT_EQ(n.x + n.y + n.z, 1);                     // along an axis ...
    EXPECT_FLOAT_EQ(glm::dot(c.normal_M, c.position_M), 1);  // ... and outwards
  }
}

TEST(MeshTopology, CreaseAngleDecidesWhatIsSharp) {
  // Faces of an icosahedron meet at pi - 2.412 = 0.7297 rad (dihedral angle arccos(-sqrt(5) / 3)).
  EXPECT_EQ(sharpEdges(meshTopology(*icosphere(0), 0.729f)), 30);
  EXPECT_EQ(sharpEdges(meshTopology(*icosphere(0), 0.730f)), 0);
}

// The weights of the vertex normals are exact for vertices on a sphere.
TEST(MeshTopology, NormalsOfASphereAreRadial) {
  const MeshTopology topology = meshTopology(*icosphere(3), 0.6f);
  EXPECT_EQ(topology.corners.size(), 642);  // 10 * 4^3 + 2: one to a vertex
  float worst = 0;
  for (const MeshCorner& c : topology.corners) worst = std::max(worst, glm::distance(c.normal_M, c.position_M));
  EXPECT_LT(worst, 1e-6f);  // measured 1.6e-7
}

TEST(MeshTopology, TheRimOfAHemisphereIsOneLoop) {
  const MeshTopology topology = meshTopology(*hemisphere(24, 8), 0.6f);
  ASSERT_EQ(topology.chains.size(), 1);
  EXPECT_EQ(topology.chains[0].edges.size(), 24);
  EXPECT_EQ(topology.chains[0].vertices.front(), topology.chains[0].vertices.back());
}

TEST(MeshTopology, AnOpenBorderHasSharpEdgesWithOneFace) {
  const MeshTopology topology = meshTopology({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 0.6f);
  ASSERT_EQ(topology.edges.size(), 3);
  for (const MeshEdge& e : topology.edges) {
    EXPECT_TRUE(e.sharp);
    EXPECT_EQ(e.right, kNoFace);
  }
}

TEST(MeshTopology, IgnoresDegenerateFacesInCreasesAndNormals) {
  draw::TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5f, 0.5f, 0}}, {}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}, {4, 2, 3}};  // the second has no area
  const MeshTopology topology = meshTopology(mesh, 0.6f);
  EXPECT_EQ(sharpEdges(topology), 4);  // the border
  for (const MeshCorner& c : topology.corners) EXPECT_EQ(c.normal_M, glm::vec3(0, 0, 1));
}

/// Returns whether a face of cubesAtAnEdge() belongs to the cube at x, y > 0, not to the cube at x, y < 0.
bool isOfTheSecond(const draw::TriangleMesh& mesh, std::uint32_t face) {
  glm::vec3 sum(0);
  for (const std::uint32_t i : mesh.triangles[face]) sum += mesh.vertices_M[i];
  return sum.x + sum.y > 0;
}

// Each cube has its own copy of the shared edge.
TEST(MeshTopology, PairsOppositeSidesWhereFourFacesMeet) {
  const MeshPointer mesh = cubesAtAnEdge();
  const MeshTopology topology = meshTopology(*mesh, 0.6f);
  EXPECT_EQ(topology.edges.size(), 36);  // 12 edges and 6 diagonals of each cube
  EXPECT_EQ(sharpEdges(topology), 24);
  for (const MeshEdge& e : topology.edges)
    EXPECT_EQ(isOfTheSecond(*mesh, e.left), isOfTheSecond(*mesh, e.right)) << e.from << " to " << e.to;
}

TEST(MeshTopology, RefusesAnIndexWithoutAVertex) {
  EXPECT_THROW(meshTopology({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}}, 0.6f), std::logic_error);
}

}  // namespace
}  // namespace poinsot::render
