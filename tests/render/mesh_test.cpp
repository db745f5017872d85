// SPDX-License-Identifier: Apache-2.0
// Meshes: exact areas, edges compared with many samples a pixel, and meshes together with other solids.
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>

#include "hull.h"
#include "mesh_sample.h"
#include "picture_test.h"
#include "random.h"
#include "render/reference.h"

namespace poinsot::render {
namespace {

using draw::Color;
using draw::DrawList;
using glm::mat3;
using glm::vec3;

const Color kGreen = draw::fromSrgb(0x009E73), kBlue = draw::fromSrgb(0x0072B2);

class MeshTest : public PictureTest {
 protected:
  /// Returns the tilted axes of a body, the same in every test.
  static mat3 tilted(float size) {
    Random random;
    return randomAxes(random, size);
  }

  DrawList listOf(MeshPointer mesh, float size, draw::Material material = {kGreen, 0.2f}) {
    DrawList list = emptyList();
    list.meshes.push_back(meshOf(std::move(mesh), tilted(size), material));
    return list;
  }

  double areaFor(MeshPointer mesh, float size) {
    return blackArea(render(listOf(std::move(mesh), size, black())));
  }
};

// The outline of a convex body is the hull of its corners in the picture.
TEST_F(MeshTest, CubesAndTetrahedraHaveTheAreaOfTheirHull) {
  Random random;
  double worst = 0;
  for (int trial = 0; trial < 60; ++trial) {
    DrawList list = emptyList();
    draw::Mesh mesh =
        meshOf(trial % 2 ? cube() : tetrahedron(), randomAxes(random, random.in(0.01f, 0.45f)), black());
    mesh.origin_V = vec3{random.in(-1, 1), random.in(-0.2f, 0.2f), random.in(-0.2f, 0.2f)};
    std::vector<glm::vec2> corners;
    for (const vec3& v : mesh.mesh->vertices_M)
      corners.push_back(project(list.camera, mesh.origin_V + mesh.axes_V * v));
    list.meshes.push_back(mesh);
    const double area = hullArea(corners), error = std::abs(blackArea(render(list)) - area);
    worst = std::max(worst, error / std::sqrt(area));
    // The remaining error comes from 8-bit values along an edge as long as the root of the area.
    EXPECT_LT(error, 0.005 * std::sqrt(area) + 0.01) << "trial " << trial << " of " << area << " pixels";
  }
  RecordProperty("worst_error_per_edge_pixel", std::to_string(worst));  // measured 0.0023
}

struct Body {
  const char* name;
  MeshPointer mesh;
  float size;
  float worstLight = 0.03f;  // 16 x 16 samples may be 1/32 off themselves; measured 0.024
};

std::vector<Body> bodies() {
  return {{"cube", cube(), 0.4f},
          {"tetrahedron", tetrahedron(), 0.5f},
          {"L prism", lPrism(), 0.5f},
          {"two cubes that share an edge", cubesAtAnEdge(), 0.4f},
          {"icosahedron", icosphere(0), 0.6f},
          {"sphere of 20480 triangles", icosphere(5), 0.6f},
          {"the same, 8 pixels wide", icosphere(5), 0.05f},
          {"rough, several triangles to a pixel", roughSphere(5, 0.02f), 0.3f, 0.07f},
          {"torus", torus(0.4f, 96, 48), 0.5f},
          {"hemisphere", hemisphere(48, 12), 0.6f}};
}

TEST_F(MeshTest, EdgesAgreeWithTheReferencePicture) {
  for (const Body& body : bodies()) {
    const DrawList list = listOf(body.mesh, body.size);
    const Difference d = difference(render(list), renderReference(renderer_, list, kSize, 16));
    RecordProperty(std::string(body.name) + " mean", std::to_string(d.mean));
    RecordProperty(std::string(body.name) + " worst light", std::to_string(d.worstLight));
    EXPECT_LT(d.mean, 2.5) << body.name;                    // of 255; measured 1.1 to 1.6, rough 2.2
    EXPECT_LE(d.worstLight, body.worstLight) << body.name;  // rough: measured 0.057, small folds along the outline
  }
}

TEST_F(MeshTest, ManyMeshesAgreeWithTheReferencePicture) {
  DrawList list = emptyList();
  Random random;
  for (const Body& body : bodies()) {
    draw::Mesh mesh = meshOf(body.mesh, randomAxes(random, 0.6f * body.size), {kBlue, 0.3f});
    mesh.material.color = 0.2f + 0.4f * (random.direction() + 1.0f);
    // Bodies stand behind one another, because the renderer does not resolve meshes that cut each other.
    const float x = 0.9f * static_cast<float>(list.meshes.size()) - 3;
    mesh.origin_V = {x, random.in(-0.7f, 0.7f), random.in(-0.5f, 0.5f)};
    list.meshes.push_back(mesh);
  }
  const image::Image picture = render(list);
  const Difference d = difference(picture, renderReference(renderer_, list, kSize, 16));
  RecordProperty("mean", std::to_string(d.mean));
  RecordProperty("worst light", std::to_string(d.worstLight));
  EXPECT_LT(d.mean, 2.0);          // measured 1.20
  EXPECT_LE(d.worstLight, 0.06f);  // measured 0.049, where three meet
  std::reverse(list.meshes.begin(), list.meshes.end());
  EXPECT_LE(difference(render(list), picture).worst, 1);
}

// Boxes and meshes are made by different code; a box may also have left-handed axes.
TEST_F(MeshTest, ABoxLooksLikeTheMeshOfACube) {
  mat3 axes = tilted(0.4f);
  axes[1] *= 0.6f;
  DrawList mesh = emptyList();
  mesh.meshes.push_back(meshOf(cube(), axes, {kGreen, 0.2f}));
  const image::Image expected = render(mesh);
  for (const float side : {1.0f, -1.0f}) {
    DrawList box = emptyList();
    box.boxes.push_back({vec3(0), mat3(axes[0], axes[1], side * axes[2]), {kGreen, 0.2f}});
    EXPECT_LE(difference(render(box), expected).worst, 1) << side;
  }
}

TEST_F(MeshTest, ABoxWithoutVolumeDrawsNothing) {
  DrawList list = emptyList();
  list.boxes.push_back({vec3(0), mat3(vec3(1, 0, 0), vec3(0, 1, 0), vec3(0)), black()});
  EXPECT_EQ(blackArea(render(list)), 0);
}

// The mesh's corners are on the ellipsoid, so that its outline lies inside by the sagitta, at most 0.01 pixel
// here.
TEST_F(MeshTest, AFineEllipsoidLooksLikeTheEllipsoidOfTheDrawList) {
  mat3 axes = tilted(0.6f);
  axes[1] *= 0.5f;
  axes[2] *= 0.8f;
  DrawList exact = emptyList(), mesh = emptyList();
  exact.ellipsoids.push_back({vec3(0), axes, {kGreen, 0.2f}});
  mesh.meshes.push_back(meshOf(icosphere(6), axes, {kGreen, 0.2f}));
  const Difference d = difference(render(exact), render(mesh));
  RecordProperty("mean", std::to_string(d.mean));
  RecordProperty("worst light", std::to_string(d.worstLight));
  EXPECT_LT(d.mean, 1.5);          // measured 1.06
  EXPECT_LE(d.worstLight, 0.02f);  // measured 0.0151
}

TEST_F(MeshTest, PaperShowsThroughTheHoleOfATorus) {
  DrawList list = emptyList();
  // The mesh's z axis points towards the eye.
  list.meshes.push_back(
      meshOf(torus(0.3f, 64, 32), 0.7f * mat3(vec3(0, 1, 0), vec3(0, 0, 1), vec3(1, 0, 0)), black()));
  const image::Image picture = render(list);
  EXPECT_EQ(*picture.at(100, 80), 255);
  EXPECT_EQ(*picture.at(100 + 56, 80), 0);  // 0.7 * 80 pixels: the middle of the tube
  EXPECT_EQ(*picture.at(100, 80 - 56), 0);
  EXPECT_EQ(*picture.at(100 + 76, 80), 255);  // 0.7 * 1.3 * 80 = 73 is the outer edge
}

// A plane runs through the middle of a cube: the near half hides the plane, the far half shows through it.
TEST_F(MeshTest, AGlassSheetCanCutThroughAMesh) {
  DrawList list = emptyList();
  list.meshes.push_back(meshOf(cube(), mat3(0.3f), black()));
  draw::GridPlane plane;
  plane.u_V = {0, 0.8f, 0};
  plane.v_V = {0.5f, 0, 0.2f};  // rises away from the eye: before the cube in the lower half of the picture
  plane.centre_V = {0.3f, 0, 0};
  plane.color = Color(0.0f, 0.8f, 0.0f);
  plane.opacity = 0.5f;
  plane.lineOpacity = 0;
  list.planes.push_back(plane);
  const image::Image picture = render(list);
  const auto greenAt = [&](int x, int y) { return picture.at(x, y)[1]; };
  EXPECT_NEAR(greenAt(100, 74), draw::srgb8FromLinear(0.4f) * (greenAt(100, 74) > 0), 1);
  EXPECT_NE(greenAt(100, 74) > 0, greenAt(100, 86) > 0);  // before on one side of the cut, behind on the other
}

// An edge that covers a part of a pixel shows the sheet behind in the rest, as with every solid.
TEST_F(MeshTest, EdgesBlendOverTheSheetsBehindThem) {
  DrawList list = emptyList();
  draw::Mesh mesh = meshOf(cube(), mat3(0.25f), black());
  mesh.origin_V = {-0.25f, 0, 0};  // its near face at x = 0, 40 pixels wide: from 80 to 120
  list.meshes.push_back(mesh);
  draw::GridPlane plane;
  plane.centre_V = {-1, 0, 0};
  plane.u_V = {0, 0.9f, 0};
  plane.v_V = {0, 0, 0.9f};
  plane.color = Color(0.5f, 0.25f, 0.1f);
  plane.opacity = 1;
  plane.lineOpacity = 0;
  list.planes.push_back(plane);
  list.camera.centre_px.x += 0.25f;
  const image::Image picture = render(list);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(picture.at(80, 80)[c], draw::srgb8FromLinear(0.25f * plane.color[c]), 1);  // a quarter is sheet
    EXPECT_NEAR(picture.at(120, 80)[c], draw::srgb8FromLinear(0.75f * plane.color[c]), 1);
  }
}

TEST_F(MeshTest, ASheetBetweenTwoMeshesStaysBetweenThemAtTheEdge) {
  DrawList list = emptyList();
  list.camera.centre_px.x += 0.5f;
  draw::Mesh near = meshOf(cube(), mat3(0.25f), black()), far = near;
  near.origin_V = {-0.25f, 0, 0};  // its right edge in the middle of column 120
  far.origin_V = {-2, 0, 0};
  far.axes_V = mat3(0.8f);
  far.material = {Color(1), 0};
  list.meshes = {near, far};
  draw::GridPlane plane;
  plane.centre_V = {-0.7f, 0, 0};
  plane.u_V = {0, 0.9f, 0};
  plane.v_V = {0, 0, 0.9f};
  plane.color = Color(0, 0, 1);
  plane.opacity = 0.5f;
  plane.lineOpacity = 0;
  list.planes.push_back(plane);
  const image::Image picture = render(list);
  for (int c = 0; c < 3; ++c) {
    const float beside = draw::linearFromSrgb8(picture.at(130, 80)[c]);  // the sheet over the far mesh
    EXPECT_NEAR(picture.at(120, 80)[c], draw::srgb8FromLinear(0.5f * beside), 2);
  }
}

// The light comes from the upper left, in front of the body.
TEST_F(MeshTest, FacesTowardsTheLightAreBrighter) {
  DrawList list = emptyList();
  const float c = std::sqrt(0.5f);
  // An upright edge of the cube points at the eye and is tipped a little, so that top, left and right faces are
  // seen.
  const mat3 turned(vec3(c, c, 0), vec3(-c, c, 0), vec3(0, 0, 1));
  const mat3 tip(vec3(0.9f, 0, -0.4359f), vec3(0, 1, 0), vec3(0.4359f, 0, 0.9f));
  list.meshes.push_back(meshOf(cube(), 0.4f * tip * turned, {Color(0.5f), 0}));
  const image::Image picture = render(list);
  const int top = *picture.at(100, 52), left = *picture.at(80, 85), right = *picture.at(120, 85);
  EXPECT_GT(top, left + 10);
  EXPECT_GT(left, right + 10);
}

TEST_F(MeshTest, FacesAreFlatOnlyBeyondTheCreaseAngle) {
  const auto colors = [&](float crease) {
    DrawList list = listOf(icosphere(0), 0.6f, {kGreen, 0});
    list.meshes[0].crease_rad = crease;
    const image::Image picture = render(list);
    std::set<int> seen;
    for (int x = 60; x < 140; ++x) seen.insert(picture.at(x, 80)[1]);
    return seen.size();
  };
  EXPECT_LT(colors(0.6f), 16);  // a few faces, and pixels between two
  EXPECT_GT(colors(1.0f), 24);
}

TEST_F(MeshTest, NoMeshAndAnEmptyMeshDrawNothing) {
  DrawList list = emptyList();
  list.meshes.emplace_back();
  list.meshes.push_back(meshOf(std::make_shared<const draw::TriangleMesh>(), mat3(1), black()));
  EXPECT_EQ(blackArea(render(list)), 0);
}

TEST_F(MeshTest, RefusesMirroredAxes) {
  DrawList list = listOf(cube(), 0.3f);
  list.meshes[0].axes_V[0] *= -1.0f;
  EXPECT_THROW(render(list), std::logic_error);
}

TEST_F(MeshTest, ASmallPictureEqualsThePartOfALargerOne) {
  DrawList list = listOf(torus(0.4f, 48, 24), 0.9f);
  list.meshes[0].origin_V = {0, 0.7f, -0.5f};
  const image::Image small = render(list);
  const image::PixelSize large{360, 320};
  list.camera.size_px = {large.width, large.height};
  list.camera.tanHalfFovY *= 2;
  list.camera.centre_px += glm::vec2(80, 80);
  const image::Image window = renderer_.render(list, large);
  ASSERT_LT(blackArea(small), 0.9 * blackArea(window));
  int worst = 0;
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x)
      for (int c = 0; c < 3; ++c)
        worst = std::max(worst, std::abs(small.at(x, y)[c] - window.at(x + 80, y + 80)[c]));
  RecordProperty("worst", worst);
  EXPECT_LE(worst, 1);  // sums of floats differ; measured 1
}

TEST_F(MeshTest, AMeshThatReachesTheNearDistanceIsLeftOut) {
  DrawList list = listOf(cube(), 0.3f);
  list.meshes[0].origin_V = {4.9f, 0, 0};  // 5.1 from the eye, the near distance is 5
  EXPECT_EQ(blackArea(render(list)), 0);
  list.meshes[0].origin_V = {4.0f, 0, 0};
  EXPECT_GT(blackArea(render(list)), 1000);
}

// For films, the renderer keeps a mesh from picture to picture. A new mesh at the same address must not be
// mistaken for the old one.
TEST_F(MeshTest, TheSameListGivesTheSameBytesAgain) {
  const DrawList list = listOf(torus(0.4f, 48, 24), 0.5f);
  const image::Image first = render(list);
  EXPECT_EQ(render(list), first);
  render(listOf(cube(), 0.3f));
  render(emptyList());
  EXPECT_EQ(render(list), first);
  const image::Image other = render(listOf(cube(), 0.3f));
  for (int i = 0; i < 20; ++i) EXPECT_EQ(render(listOf(cube(), 0.3f)), other);
}

// Many triangles share a pixel. A body that moves by fractions of a pixel keeps its area, because areas are exact
// and no sample can miss a triangle.
TEST_F(MeshTest, TinyTrianglesDoNotSparkle) {
  double least = 1e9, most = 0;
  for (int i = 0; i < 16; ++i) {
    DrawList list = listOf(icosphere(5), 0.03f, black());
    list.camera.centre_px += glm::vec2(0.137f, 0.211f) * static_cast<float>(i);
    const double area = blackArea(render(list));
    least = std::min(least, area);
    most = std::max(most, area);
  }
  RecordProperty("least", std::to_string(least));
  RecordProperty("most", std::to_string(most));
  EXPECT_NEAR(least, std::numbers::pi * 2.4 * 2.4, 0.05);  // a disc of 0.03 * 80 pixels; measured 0.029
  EXPECT_NEAR(most, std::numbers::pi * 2.4 * 2.4, 0.05);
}

}  // namespace
}  // namespace poinsot::render
