// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_parts.h"

#include <gtest/gtest.h>

#include "geometry/mesh_integrals.h"
#include "geometry/mesh_samples.h"

namespace poinsot::geometry {
namespace {

Mesh cubeAt(double edge, double x) { return transformed(cubeMesh(edge), Eigen::Matrix3d::Identity(), {x, 0, 0}); }

TEST(MeshParts, FindsAnInsideOutPartAmongOthers) {
  const Mesh mesh = joined(cubeAt(2, 0), flipped(cubeAt(1, 3)));
  EXPECT_EQ(refusal([&] { checkClosed(mesh); }),
            "the part of the mesh that has a corner at (3.5, 0.5, 0.5) is inside out and is not inside another "
            "part; flip its triangles (swap two corners of each)");
  const auto triangle = strayCavity(mesh);
  ASSERT_TRUE(triangle);
  EXPECT_GE(*triangle, 12U);
}

TEST(MeshParts, AcceptsCavitiesAndSeparateParts) {
  EXPECT_FALSE(strayCavity(joined(cubeAt(2, 0), flipped(cubeAt(1, 0)))));
  EXPECT_FALSE(strayCavity(joined(cubeAt(2, 0), joined(flipped(cubeAt(1, 0)), cubeAt(.5, 0)))));
  EXPECT_FALSE(strayCavity(joined(cubeAt(2, 0), cubeAt(1, 3))));
  for (const Sample& sample : primitives(9)) EXPECT_FALSE(strayCavity(sample.mesh)) << sample.name;
}

TEST(MeshParts, FindsAnInsideOutPartFarFromTheOrigin) {
  EXPECT_FALSE(strayCavity(joined(cubeAt(2, 1e8), cubeAt(1e-3, 2e8))));
  EXPECT_TRUE(strayCavity(joined(cubeAt(2, 1e8), flipped(cubeAt(1e-3, 2e8)))));
}

// Flat parts have no volume, and so no sign of the volume.
TEST(MeshParts, IgnoresFlatParts) {
  Mesh mesh = cubeAt(1, 0);
  for (const double z : {.1, .7})
    mesh = joined(mesh, {{{5, 0, z}, {6, .3, z}, {5, 1, z / 3}}, {{0, 1, 2}, {0, 2, 1}}});
  EXPECT_FALSE(strayCavity(mesh));
}

// Half of the 40 000 parts are inside out, so that a comparison would take 4e8 steps.
TEST(MeshParts, SkipsTheComparisonOfTooManyParts) {
  Mesh mesh;
  const Mesh one = tetrahedronMesh(1e-3);
  for (int i = 0; i < 40'000; ++i) {
    const auto shift = static_cast<std::uint32_t>(mesh.vertices_M.size());
    for (const Eigen::Vector3d& v : one.vertices_M) mesh.vertices_M.push_back(v + Eigen::Vector3d(i, 0, 0));
    for (const auto& [a, b, c] : one.triangles)
      mesh.triangles.push_back(i % 2 ? Mesh::Triangle{a + shift, b + shift, c + shift}
                                     : Mesh::Triangle{b + shift, a + shift, c + shift});
  }
  EXPECT_FALSE(strayCavity(mesh));
}

}  // namespace
}  // namespace poinsot::geometry
