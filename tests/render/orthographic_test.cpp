// SPDX-License-Identifier: Apache-2.0
// Parallel rays: each drawn thing looks as a perspective camera sees it from very far away, and known sizes hold.
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "mesh_sample.h"
#include "picture_test.h"
#include "render/reference.h"

namespace poinsot::render {
namespace {

using draw::DrawList;
using glm::vec3;

const draw::Color kGreen = draw::fromSrgb(0x009E73), kBlue = draw::fromSrgb(0x0072B2);

class OrthographicTest : public PictureTest {
 protected:
  /// Returns an empty list with a parallel camera, with 80 pixels to the unit as in the middle of the perspective
  /// one.
  static DrawList parallelList() {
    DrawList list = emptyList();
    list.camera = draw::orthographic(list.camera, vec3(0));
    return list;
  }

  /// Returns the same picture in perspective from 3000 away, where a thing that is 1 nearer looks larger by
  /// 1/3000.
  static DrawList fromFarAway(DrawList list) {
    constexpr float kDistance = 3000;
    list.camera.orthographic = false;
    list.camera.tanHalfFovY = list.camera.halfHeight_V / kDistance;
    list.camera.eye_V = kDistance * list.camera.R_VC[2];
    list.camera.near = kDistance - 5;
    list.camera.far = kDistance + 5;
    return list;
  }

  /// @param mostValues  number of values that may differ by more than worstLight
  void expectAsFromFarAway(const DrawList& list, const char* what, float worstLight, int mostValues = 0) {
    const image::Image parallel = render(list);
    ASSERT_GT(difference(parallel, render(emptyList())).count, 200) << what;
    const Difference d = difference(parallel, render(fromFarAway(list)), worstLight);
    RecordProperty(std::string(what) + " worst light", std::to_string(d.worstLight));
    EXPECT_LE(d.beyond, mostValues) << what << ", by up to " << d.worstLight;
  }

  static draw::Mesh tilted(MeshPointer mesh) {
    Random random;
    return meshOf(std::move(mesh), randomAxes(random, 0.4f), {kGreen, 0.3f});
  }
};

TEST_F(OrthographicTest, ASphereIsACircleOfItsRadiusWhereverItIs) {
  for (const vec3 centre : {vec3(0), vec3(3, 0.5f, 0.3f), vec3(-3, -0.6f, -0.4f)}) {
    DrawList list = parallelList();
    list.ellipsoids.push_back({centre, glm::mat3(0.3f), black()});
    EXPECT_NEAR(blackArea(render(list)), std::numbers::pi * 24 * 24, 0.6);
  }
}

TEST_F(OrthographicTest, DrawsSolidsAsSeenFromFarAway) {
  DrawList ellipsoid = parallelList();
  ellipsoid.ellipsoids.push_back(
      {{0.5f, 0.2f, -0.1f}, glm::mat3(0.5f, 0.1f, 0, -0.1f, 0.6f, 0.2f, 0, -0.1f, 0.3f), {kBlue, 0.3f}});
  ellipsoid.ellipsoids[0].marking_px = 2;
  expectAsFromFarAway(ellipsoid, "ellipsoid", 0.05f);  // measured 0.035, on a marking
  for (const float tip : {0.0f, 0.1f, 0.3f}) {
    for (const vec3 to : {vec3(0.3f, 0.5f, 0.4f), vec3(-0.6f, 0.2f, 0.3f), vec3(0.9f, 0.05f, 0)}) {
      DrawList frustum = parallelList();
      frustum.frustums.push_back({{0, -0.2f, -0.3f}, to, 0.3f, tip, {kBlue, 0.3f}});
      expectAsFromFarAway(frustum, "frustum", 0.03f);  // measured 0.014
    }
  }
  for (const MeshPointer& mesh : {cube(), lPrism(), torus(0.4f, 48, 24)}) {
    DrawList list = parallelList();
    list.meshes.push_back(tilted(mesh));
    expectAsFromFarAway(list, "mesh", 0.03f);  // measured 0.009
    list.meshes[0].edge_px = 2;
    expectAsFromFarAway(list, "mesh with lines", 0.08f, 3);  // measured 1 pixel, where a line ends at a corner
  }
}

TEST_F(OrthographicTest, DrawsCurvesAsSeenFromFarAway) {
  for (const float radius : {0.0f, 0.06f}) {
    DrawList list = parallelList();
    draw::Curve curve;
    for (int i = 0; i < 60; ++i) {
      const float s = 0.1f * static_cast<float>(i);
      curve.points_V.push_back({0.5f * std::cos(3 * s), 0.7f * std::cos(s), 0.6f * std::sin(2 * s)});
    }
    curve.radius_V = radius;
    curve.material = {kBlue, 0.3f};
    list.curves = {curve};
    expectAsFromFarAway(list, "curve", 0.03f);  // measured 0.015
  }
}

TEST_F(OrthographicTest, DrawsSheetsAsSeenFromFarAway) {
  DrawList list = parallelList();
  draw::GlassEllipsoid glass;
  glass.semiAxes_V = glm::mat3(0.9f, 0, 0, 0, 0.7f, 0.2f, 0, -0.1f, 0.6f);
  glass.centre_V = {0.6f, 0.2f, 0.1f};
  glass.color = kBlue;
  // The glass has no graticule: from far away, single precision is too coarse for its lines at the rim.
  list.glassEllipsoids = {glass};
  expectAsFromFarAway(list, "glass", 0.03f);  // measured 0.018
  list.glassEllipsoids.clear();
  draw::GridPlane plane;
  plane.u_V = {0.7f, 0, 0.5f};
  plane.v_V = {0, 0.8f, 0};
  list.planes = {plane};
  expectAsFromFarAway(list, "plane", 0.03f);  // measured 0.012
  list.planes.clear();
  for (const vec3 axis : {vec3(0.3f, 0.2f, 1), vec3(1, 0.2f, 0.3f), vec3(-1, 0.2f, 0.3f)}) {
    draw::GlassCone cone;
    cone.axis_V = axis;
    cone.height_V = 0.7f;
    cone.color = kGreen;
    list.glassCones = {cone};
    expectAsFromFarAway(list, "cone", 0.03f);  // measured 0.015
  }
  list.glassCones.clear();
  draw::GlassPolygon polygon;
  polygon.corners_V = {{0, 0, 0}, {0.5f, 0.6f, 0.1f}, {0.5f, 0.6f, 0.7f}, {0, 0, 0.6f}};
  list.glassPolygons = {polygon};
  expectAsFromFarAway(list, "polygon", 0.03f);  // measured 0.011
}

DrawList withEverything(DrawList list) {
  list.boxes.push_back(
      {{0, -0.6f, 0.1f}, glm::mat3(0.2f, 0.1f, 0, -0.1f, 0.2f, 0.05f, 0, -0.06f, 0.25f), {kGreen, 0.2f}});
  list.frustums.push_back({{0, 0.3f, -0.5f}, {0.2f, 0.7f, 0.1f}, 0.15f, 0, {kBlue, 0.2f}});
  list.ellipsoids.push_back(
      {{0.5f, 0, 0.5f}, glm::mat3(0.2f, 0, 0, 0, 0.3f, 0.1f, 0, -0.05f, 0.15f), {kGreen, 0.2f}});
  return list;
}

// Checks depths too, that is, what hides what, against many hard-edged samples.
TEST_F(OrthographicTest, AgreesWithTheReferencePicture) {
  const DrawList list = withEverything(parallelList());
  const Difference d = difference(render(list), renderReference(renderer_, list, kSize, 16));
  ASSERT_GT(d.count, 500);
  RecordProperty("mean", std::to_string(d.mean));
  EXPECT_LT(d.mean, 2);  // measured 1.56
}

TEST_F(OrthographicTest, NearObjectsHideFarObjects) {
  DrawList list = parallelList();
  list.boxes = {{{-2, 0, 0}, glm::mat3(0.5f), {draw::Color(1), 0}}, {{2, 0, 0}, glm::mat3(0.3f), black()}};
  std::vector<vec3> square{{1, -0.4f, -0.4f}, {1, 0.4f, -0.4f}, {1, 0.4f, 0.4f}, {1, -0.4f, 0.4f}};
  draw::GlassPolygon behind;
  behind.corners_V = square;
  behind.opacity = 1;
  behind.color = draw::Color(0, 1, 0);
  behind.lineOpacity = 0;
  list.glassPolygons = {behind};
  const image::Image picture = render(list);
  EXPECT_EQ(picture.at(100, 80)[1], 0);       // the near box
  EXPECT_EQ(picture.at(100 + 28, 80)[0], 0);  // the sheet between
  EXPECT_EQ(picture.at(100 + 28, 80)[1], 255);
  EXPECT_GT(picture.at(100 + 36, 80)[0], 100);  // the far box
}

}  // namespace
}  // namespace poinsot::render
