// SPDX-License-Identifier: Apache-2.0
// Any change of a picture changes its digest, and equal pictures have one digest.
#include "draw/picture_digest.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace poinsot::draw {
namespace {

Picture everything() {
  Picture picture;
  picture.panels.resize(1);
  DrawList& list = picture.panels[0].list;
  list.ellipsoids.resize(1);
  list.frustums.resize(1);
  list.boxes.resize(1);
  list.meshes.resize(1);
  list.meshes[0].mesh =
      std::make_shared<TriangleMesh>(TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  list.curves.resize(1);
  list.curves[0].points_V = {{0, 0, 0}, {1, 2, 3}};
  list.glassEllipsoids.resize(1);
  list.glassEllipsoids[0].graticule.emplace();
  list.glassCones.resize(1);
  list.glassPolygons.resize(1);
  list.planes.resize(1);
  list.texts.resize(1);
  picture.areas.resize(1);
  picture.strokes.resize(1);
  picture.texts.resize(1);
  return picture;
}

// Changes of each kind of value, near the end of each struct, where a forgotten field would stand.
const std::vector<std::function<void(Picture&)>>& changes() {
  const auto list = [](Picture& p) -> DrawList& { return p.panels[0].list; };
  static const std::vector<std::function<void(Picture&)>> all = {
      [](Picture& p) { p.size_px.y += 1; },
      [](Picture& p) { p.background.z = 0.999f; },
      [](Picture& p) { p.panels[0].origin_px.x = 1; },
      [=](Picture& p) { list(p).camera.centre_px.y += 0.5f; },
      [=](Picture& p) { list(p).camera.orthographic = true; },
      [=](Picture& p) { list(p).background.x = 0.5f; },
      [=](Picture& p) { list(p).lightDirection_C.z = 0; },
      [=](Picture& p) { list(p).ellipsoids[0].marking_px = 1; },
      [=](Picture& p) { list(p).ellipsoids.emplace_back(); },
      [=](Picture& p) { list(p).frustums[0].material.gloss = 0; },
      [=](Picture& p) { list(p).boxes[0].halfAxes_V[2].z = 2; },
      [=](Picture& p) { list(p).meshes[0].edge_px = 1; },
      [=](Picture& p) { list(p).meshes[0].mesh = nullptr; },
      [=](Picture& p) {
        TriangleMesh other = *list(p).meshes[0].mesh;
        other.triangles[0][2] = 1;
        list(p).meshes[0].mesh = std::make_shared<TriangleMesh>(other);
      },
      [=](Picture& p) { list(p).curves[0].points_V[1].z = 3.0000002f; },
      [=](Picture& p) { list(p).curves[0].material.color.x = 0; },
      [=](Picture& p) { list(p).glassEllipsoids[0].graticule->farOpacity = 0; },
      [=](Picture& p) { list(p).glassEllipsoids[0].graticule.reset(); },
      [=](Picture& p) { list(p).glassCones[0].lineWidth_px = 1; },
      [=](Picture& p) { list(p).glassPolygons[0].lineWidth_px = 1; },
      [=](Picture& p) { list(p).planes[0].shadowOpacity = 0.1f; },
      [=](Picture& p) { list(p).texts[0].halo_px = 1; },
      [](Picture& p) { p.areas[0].opacity = 0.5f; },
      [](Picture& p) { p.strokes[0].opacity = 0.5f; },
      [](Picture& p) { p.texts[0].tex = "a"; },
      [](Picture& p) { p.texts[0].halo = Color(0); },
      [](Picture& p) { p.panels.emplace_back(); },
  };
  return all;
}

TEST(PictureDigest, IsEqualForEqualPicturesAndDiffersForEachChange) {
  PictureDigester digestOf;
  std::set<core::Digest> seen{digestOf(everything())};
  EXPECT_EQ(digestOf(everything()), *seen.begin());  // another mesh of the same triangles
  for (std::size_t i = 0; i < changes().size(); ++i) {
    Picture picture = everything();
    changes()[i](picture);
    EXPECT_TRUE(seen.insert(digestOf(picture)).second) << "change " << i;
    EXPECT_TRUE(seen.contains(PictureDigester()(picture))) << "change " << i;
  }
}

TEST(PictureDigest, IgnoresNamedPoints) {
  Picture named = everything();
  named.panels[0].list.points.push_back({"L", {1, 2, 3}});
  EXPECT_EQ(PictureDigester()(named), PictureDigester()(everything()));
}

// A mesh is freed and another made at its address. The digest remembered for the first must not be used for the
// second.
TEST(PictureDigest, DoesNotReuseTheDigestOfAFreedMesh) {
  PictureDigester digestOf;
  std::set<core::Digest> seen;
  for (float x = 0; x < 50; ++x) {
    Picture picture = everything();
    picture.panels[0].list.meshes[0].mesh = std::make_shared<TriangleMesh>(TriangleMesh{{{x, 0, 0}}, {}});
    EXPECT_TRUE(seen.insert(digestOf(picture)).second) << x;
  }
}

}  // namespace
}  // namespace poinsot::draw
