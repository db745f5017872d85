// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_joining.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/mesh_integrals.h"
#include "geometry/mesh_samples.h"

namespace poinsot::geometry {
namespace {

using Eigen::Vector3d;

/// Returns the triangles of a mesh, each with separate corners, as in an STL file.
Mesh soupOf(const Mesh& mesh) {
  Mesh soup;
  for (const Mesh::Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.vertices_M.size());
    for (const std::uint32_t i : t) soup.vertices_M.push_back(mesh.vertices_M[i]);
    soup.triangles.push_back({first, first + 1, first + 2});
    soup.places.push_back(atLine(soup.triangles.size()));
  }
  return soup;
}

Vector3d noise(Draw& draw, double most) {
  return {draw.between(-most, most), draw.between(-most, most), draw.between(-most, most)};
}

// In one triangle a corner of a box of 2 x 1 x 3 has 2.4e-18 instead of 0, as CAD programs write.
TEST(MeshJoining, ClosesABoxWithRoundingAtZero) {
  Mesh box = soupOf(transformed(boxMesh({2, 1, 3}), Eigen::Matrix3d::Identity(), {1, .5, 1.5}));
  const auto corner = std::ranges::find(box.vertices_M, Vector3d(0, 0, 0));
  ASSERT_NE(corner, box.vertices_M.end());
  (*corner)[2] = 2.4186773518759718e-18;
  const auto closed = closedByJoining(welded(box));
  ASSERT_TRUE(closed);
  EXPECT_EQ(closed->corners, 1U);
  EXPECT_NEAR(closed->farthest / 2.4186773518759718e-18, 1, 1e-15);
  EXPECT_EQ(closed->size, 3);
  EXPECT_EQ(closed->mesh.vertices_M.size(), 8U);
  EXPECT_EQ(closed->mesh.triangles.size(), 12U);
  EXPECT_NO_THROW(checkClosed(closed->mesh));
  EXPECT_NEAR(integrals(closed->mesh).volume_m3, 6, 1e-15);  // measured 0
}

TEST(MeshJoining, KeepsAClosedMeshUnchanged) {
  for (const Sample& sample : primitives(9)) EXPECT_FALSE(closedByJoining(sample.mesh)) << sample.name;
}

// Corners to be joined lie on both sides of cell borders and of round numbers.
TEST(MeshJoining, FindsNeighboursAcrossCellBorders) {
  Draw draw(31);
  for (const double part : {4e-10, 4e-7})
    for (const Sample& sample : primitives(12))
      for (int trial = 0; trial < 20; ++trial) {
        const double size = boundsOf(sample.mesh).size_m().maxCoeff();
        const Mesh whole = transformed(sample.mesh, Eigen::Matrix3d::Identity(), noise(draw, 3 * size));
        Mesh soup = soupOf(whole);
        for (Vector3d& v : soup.vertices_M) v += noise(draw, part * size);
        const auto closed = closedByJoining(welded(soup));
        ASSERT_TRUE(closed) << sample.name;
        EXPECT_EQ(closed->mesh.vertices_M.size(), sample.mesh.vertices_M.size()) << sample.name;
        EXPECT_EQ(closed->mesh.triangles.size(), sample.mesh.triangles.size()) << sample.name;
        EXPECT_LE(closed->farthest, std::sqrt(3) * 2 * part * size);
        EXPECT_NEAR(integrals(closed->mesh).volume_m3 / integrals(whole).volume_m3, 1, 25 * part);  // measured 13
      }
}

TEST(MeshJoining, ClosesWithinTheRoundingOfFloats) {
  Mesh cube = soupOf(cubeMesh(1));
  cube.vertices_M[4][0] = static_cast<double>(std::nextafter(static_cast<float>(cube.vertices_M[4][0]), 9.f));
  const auto closed = closedByJoining(welded(cube));
  ASSERT_TRUE(closed);
  EXPECT_LE(closed->farthest, 0x1p-24);
  EXPECT_GE(closed->farthest, 0x1p-25);
}

TEST(MeshJoining, KeepsAnOpenMeshUnchanged) {
  for (const Sample& sample : primitives(9)) {
    Mesh open = sample.mesh;
    open.triangles.pop_back();
    EXPECT_FALSE(closedByJoining(open)) << sample.name;
    Mesh moved = soupOf(sample.mesh);
    moved.vertices_M[0] += Vector3d(0, 0, 1e-5 * boundsOf(sample.mesh).size_m().maxCoeff());
    EXPECT_FALSE(closedByJoining(welded(moved))) << sample.name;
  }
}

TEST(MeshJoining, KeepsDetailAwayFromOpenEdges) {
  const Mesh speck = transformed(cubeMesh(1e-11), Eigen::Matrix3d::Identity(), {.1, .2, .8});
  Mesh box = soupOf(cubeMesh(1));
  box.vertices_M[4][1] += 1e-15;
  const auto closed = closedByJoining(joined(welded(box), speck));
  ASSERT_TRUE(closed);
  EXPECT_EQ(closed->mesh.vertices_M.size(), 16U);
  EXPECT_EQ(closed->mesh.triangles.size(), 24U);
}

// Beside a cube lies a ribbon of triangles, narrower than the tolerance and 1000 times as long. If neighbours of
// neighbours were joined, the ribbon would vanish and leave a closed surface.
TEST(MeshJoining, DoesNotJoinChainsOfNeighbours) {
  for (const double reach : {1e-9, 1e-6}) {
    Mesh mesh = cubeMesh(1);
    const auto first = static_cast<std::uint32_t>(mesh.vertices_M.size());
    for (std::uint32_t i = 0; i < 1000; ++i) mesh.vertices_M.emplace_back(.9 * reach * i, (i % 2) * .5 * reach, 0);
    for (std::uint32_t i = first; i < first + 998; ++i) mesh.triangles.push_back({i, i + 1, i + 2});
    const auto closed = closedByJoining(mesh);
    EXPECT_EQ(closed.has_value(), reach == 1e-9);  // the whole ribbon fits within 1e-6 of the size
    EXPECT_LE(closed ? closed->farthest : 0, 1e-6);
  }
}

// The lower two corners of a spike on a tetrahedron are joined. The spike must vanish with its place and its tip.
TEST(MeshJoining, DropsTrianglesThatCollapse) {
  Mesh mesh = soupOf(tetrahedronMesh(1));
  const Vector3d a = mesh.vertices_M[0], b = a + Vector3d(0, 0, 1e-12);
  mesh.vertices_M.insert(mesh.vertices_M.end(), {a, b, Vector3d(5, 5, 5)});
  const auto last = static_cast<std::uint32_t>(mesh.vertices_M.size() - 1);
  mesh.triangles.push_back({last - 2, last - 1, last});
  mesh.places.push_back(atLine(99));
  const auto closed = closedByJoining(welded(mesh));
  ASSERT_TRUE(closed);
  EXPECT_EQ(closed->mesh.triangles.size(), 4U);
  EXPECT_EQ(closed->mesh.places.size(), 4U);
  EXPECT_EQ(closed->mesh.vertices_M.size(), 4U);
  for (const FilePlace& place : closed->mesh.places) EXPECT_NE(toString(place), "line 99");
}

}  // namespace
}  // namespace poinsot::geometry
