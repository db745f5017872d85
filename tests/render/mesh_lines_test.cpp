// SPDX-License-Identifier: Apache-2.0
#include "mesh_sample.h"
#include "picture_test.h"

namespace poinsot::render {
namespace {

using draw::Color;
using draw::DrawList;
using glm::mat3;
using glm::vec3;

class MeshLinesTest : public PictureTest {};

TEST_F(MeshLinesTest, DrawsLinesOnVisibleSharpEdges) {
  DrawList list = emptyList();
  draw::Mesh mesh = meshOf(cube(), mat3(0.25f), {Color(0.8f), 0});
  mesh.origin_V = {-0.25f, 0, 0};  // the near face spans columns 80 to 120
  mesh.edge_px = 3;
  mesh.edgeColor = Color(0.7f, 0, 0);
  list.meshes.push_back(mesh);
  list.camera.centre_px += 0.5f;
  const image::Image picture = render(list);
  for (const glm::ivec2 p : {glm::ivec2(80, 80), glm::ivec2(120, 80), glm::ivec2(100, 60), glm::ivec2(100, 100)}) {
    EXPECT_NEAR(picture.at(p.x, p.y)[0], draw::srgb8FromLinear(0.7f), 1);
    EXPECT_EQ(picture.at(p.x, p.y)[1], 0);
  }
  // The far edges lie 0.95 times as far out, behind the face; no diagonal is drawn.
  for (const glm::ivec2 p : {glm::ivec2(82, 80), glm::ivec2(90, 90), glm::ivec2(110, 90), glm::ivec2(100, 80)})
    EXPECT_GT(picture.at(p.x, p.y)[1], 100);
}

// All edges of the faces that are seen have unbroken lines, even beside steep faces. Edges shorter than 8 pixels
// are left out, because a line covers only half of the pixel at its end.
TEST_F(MeshLinesTest, LinesAreUnbroken) {
  Random random;
  int probes = 0, broken = 0;
  for (int trial = 0; trial < 40; ++trial) {
    DrawList list = emptyList();
    list.camera = draw::lookAt({3, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0.7f, {kSize.width, kSize.height});
    list.camera.near = 1;  // close to it: a steep perspective
    draw::Mesh mesh = meshOf(cube(), randomAxes(random, 0.5f), {Color(1), 0});
    mesh.edge_px = 2;
    list.meshes.push_back(mesh);
    const image::Image picture = render(list);
    const auto faces = [&](int axis, float side) {  // whether a face looks at the eye
      const vec3 n = side * mesh.axes_V[axis];
      return glm::dot(n, list.camera.eye_V - n) > 0;
    };
    for (int edge = 0; edge < 12; ++edge) {
      const int along = edge / 4, u = (along + 1) % 3, v = (along + 2) % 3;
      const float a = edge & 1 ? 1.0f : -1.0f, b = edge & 2 ? 1.0f : -1.0f;
      if (!faces(u, a) && !faces(v, b)) continue;
      const auto place = [&](float s) {
        return project(list.camera, s * mesh.axes_V[along] + a * mesh.axes_V[u] + b * mesh.axes_V[v]);
      };
      if (glm::distance(place(-1), place(1)) < 8) continue;
      for (float s = -0.75f; s < 0.76f; s += 0.05f) {
        const glm::vec2 at = place(s);
        ++probes;
        broken += *picture.at(static_cast<int>(at.x), static_cast<int>(at.y)) > 150;
      }
    }
  }
  EXPECT_GT(probes, 9000);
  EXPECT_LE(broken, 2);  // measured 0 of 9920
}

}  // namespace
}  // namespace poinsot::render
