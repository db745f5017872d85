// SPDX-License-Identifier: Apache-2.0
// Checks the error of edges (edge_error.h) of each kind alone and in whole pictures, against 16 x 16 samples a
// pixel (fine_picture.h). A mean of at most 2 is allowed. For scenes of the gallery see gallery_edges_test.cpp.
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

#include "edge_error.h"
#include "mesh_sample.h"
#include "picture_test.h"

namespace poinsot::render {
namespace {

using draw::DrawList;
using glm::mat3;
using glm::vec3;

constexpr int kSamples = 16;  // along a pixel's side
constexpr float kPi = std::numbers::pi_v<float>;

const draw::Color kBlue = draw::fromSrgb(0x0072B2), kVermilion = draw::fromSrgb(0xD55E00),
                  kOrange = draw::fromSrgb(0xE69F00), kGreen = draw::fromSrgb(0x009E73),
                  kInk = draw::fromSrgb(0x2B2F36);

// Returns the axes of a body that is not lined up with anything.
mat3 turned() {
  const vec3 u = glm::normalize(vec3(0.7f, 0.5f, 0.3f)), v = glm::normalize(glm::cross(u, vec3(-0.2f, 0.3f, 1)));
  return {u, v, glm::cross(u, v)};
}

mat3 turned(float a, float b, float c) {
  const mat3 axes = turned();
  return {a * axes[0], b * axes[1], c * axes[2]};
}

void addArrow(DrawList& list, vec3 from, vec3 to, float radius, draw::Color color) {
  const vec3 neck = to - 9 * radius * glm::normalize(to - from);
  draw::Curve shaft;
  shaft.points_V = {from, neck + 0.1f * (to - neck)};
  shaft.radius_V = radius;
  shaft.material = {color, 0.3f};
  list.curves.push_back(shaft);
  list.frustums.push_back({neck, to, 3 * radius, 0, {color, 0.3f}});
}

draw::Curve ringOf(mat3 semiAxes, float tilt, float width_px, draw::Color color, float lift) {
  draw::Curve curve;
  for (int i = 0; i < 240; ++i) {
    const float s = 2 * kPi * static_cast<float>(i) / 240;
    const vec3 unit(std::cos(s) * std::cos(tilt), std::sin(s) * std::cos(tilt), std::sin(tilt) * std::cos(2 * s));
    curve.points_V.push_back(semiAxes * glm::normalize(unit));
  }
  curve.closed = true;
  curve.width_px = width_px;
  curve.lift_V = lift;
  curve.material = {color, 0};
  return curve;
}

draw::GridPlane gridAt(float height, float half) {
  draw::GridPlane plane;
  plane.centre_V = {0, 0, height};
  plane.u_V = half * vec3(0.8f, 0.6f, 0);
  plane.v_V = half * vec3(-0.6f, 0.8f, 0);
  plane.spacing_V = 0.2f;
  plane.color = kBlue;
  plane.lineColor = kBlue;
  plane.lineWidth_px = 1.2f;
  plane.shadowCentre_V = {0.1f, 0.2f, height};
  plane.shadowRadius_V = 0.15f;
  plane.shadowOpacity = 0.22f;
  return plane;
}

draw::GlassEllipsoid glassOf(mat3 semiAxes, bool graticule) {
  draw::GlassEllipsoid glass;
  glass.semiAxes_V = semiAxes;
  glass.color = kOrange;
  if (graticule) glass.graticule = draw::Graticule{kVermilion, 1.2f, 0.75f, 0.3f};
  return glass;
}

// Adds arrows along the axes of a body, which leave the body on either side.
void addAxes(DrawList& list, mat3 semiAxes) {
  for (int k = 0; k < 3; ++k) addArrow(list, -1.5f * semiAxes[k], 1.8f * semiAxes[k], 0.02f, kInk);
}

class EdgeErrorTest : public PictureTest {
 protected:
  static DrawList fromAbove() {
    DrawList list = emptyList();
    list.camera = draw::lookAt({9.2f, 1.4f, 3.6f}, vec3(0), {0, 0, 1}, 1.0f, {kSize.width, kSize.height});
    list.camera.tanHalfFovY = 0.1f;
    list.camera.near = 5;
    list.camera.far = 15;
    return list;
  }

  void expectGood(const DrawList& list, const std::string& name, double bound = 2) {
    const EdgeError error = edgeError(render(list), finePicture(renderer_, list, kSamples), name);
    EXPECT_GT(error.count, 100) << name;
    EXPECT_LE(error.mean, bound) << name;
  }
};

// Comments after the calls give the means measured with OSMesa of Mesa 22.3.
TEST_F(EdgeErrorTest, IsSmallForSolids) {
  DrawList list = fromAbove();
  list.ellipsoids.push_back({vec3(0), turned(0.8f, 0.5f, 0.3f), {kGreen, 0.3f}});
  expectGood(list, "ellipsoid");  // 0.27
  list.ellipsoids[0].marking_px = 1.5f;
  expectGood(list, "ellipsoid, marked");  // 1.64

  list = fromAbove();
  list.boxes.push_back({vec3(0), turned(0.7f, 0.45f, 0.2f), {kGreen, 0.3f}});
  expectGood(list, "box");  // 0.08

  list = fromAbove();
  list.meshes.push_back(meshOf(torus(0.3f, 60, 30), turned(0.6f, 0.6f, 0.6f), {kGreen, 0.3f}));
  expectGood(list, "torus");  // 0.05

  list = fromAbove();
  list.frustums.push_back({{0, -0.6f, -0.3f}, {0.2f, 0.5f, 0.4f}, 0.3f, 0.3f, {kGreen, 0.3f}});
  expectGood(list, "cylinder");  // 0.22
  list.frustums = {{{0, -0.6f, -0.3f}, {0.8f, 0.5f, 0.4f}, 0.4f, 0, {kGreen, 0.3f}}};
  expectGood(list, "cone");  // 0.33
  list.frustums = {{{0, 0.6f, 0.3f}, {0.3f, 0.5f, -0.4f}, 0.5f, 0.2f, {kGreen, 0.3f}}};
  expectGood(list, "frustum");  // 1.25

  list = fromAbove();
  for (int i = 0; i < 8; ++i) {
    const float s = 2 * kPi * (static_cast<float>(i) + 0.3f) / 8;
    const vec3 tip(0.3f * std::cos(s + 1), 0.9f * std::cos(s), 0.85f * std::sin(s));
    addArrow(list, 0.2f * tip, tip, i % 2 ? 0.02f : 0.012f, i % 2 ? kBlue : kVermilion);
  }
  expectGood(list, "arrows");  // 1.78
}

TEST_F(EdgeErrorTest, IsSmallForLines) {
  DrawList list = fromAbove();
  const mat3 axes = turned(0.9f, 0.8f, 0.8f);
  for (int i = 0; i < 4; ++i)
    list.curves.push_back(
        ringOf(axes, 0.3f * static_cast<float>(i), 1 + 0.7f * static_cast<float>(i), i % 2 ? kBlue : kInk, 0));
  expectGood(list, "curves");  // 1.55

  list = fromAbove();
  for (int i = 0; i < 12; ++i) {
    const float s = kPi * (static_cast<float>(i) + 0.2f) / 12;
    draw::Curve line;
    line.points_V = {{0, 0.9f * std::cos(s), 0.9f * std::sin(s)}, {0, 0.3f * std::cos(s), 0.3f * std::sin(s)}};
    line.width_px = 0.6f + 0.3f * static_cast<float>(i);
    line.material = {kInk, 0};
    list.curves.push_back(line);
  }
  expectGood(list, "straight lines");  // 0.06

  list = fromAbove();
  list.planes = {gridAt(0, 0.9f)};
  expectGood(list, "grid");  // 0.85
}

TEST_F(EdgeErrorTest, IsSmallForGlass) {
  DrawList list = fromAbove();
  list.glassEllipsoids = {glassOf(turned(0.9f, 0.6f, 0.4f), false)};
  expectGood(list, "glass ellipsoid");  // 0.83
  list.glassEllipsoids = {glassOf(turned(0.9f, 0.6f, 0.4f), true)};
  expectGood(list, "graticule");  // 0.97
  list.boxes.push_back({vec3(0), turned(0.75f, 0.65f, 0.2f), {kGreen, 0.3f}});
  expectGood(list, "glass cuts a box");  // 1.37
  list.boxes.clear();
  list.ellipsoids.push_back({vec3(0), turned(0.75f, 0.65f, 0.45f), {kGreen, 0.3f}});
  expectGood(list, "glass cuts a solid");  // 0.93

  list = fromAbove();
  draw::GlassCone cone;
  cone.apex_V = {0, 0, -0.6f};
  cone.axis_V = {0.2f, 0.3f, 1};
  cone.height_V = 1;
  cone.halfAngle_rad = 0.4f;
  cone.color = kVermilion;
  cone.lineColor = kVermilion;
  list.glassCones = {cone};
  expectGood(list, "glass cone");  // 0.84
  list.glassEllipsoids = {glassOf(turned(0.9f, 0.6f, 0.4f), false)};
  expectGood(list, "cone through ellipsoid");  // 0.79

  list = fromAbove();
  list.glassPolygons = {{{{0, -0.7f, -0.6f}, {0.2f, 0.8f, -0.4f}, {0, 0.1f, 0.8f}}, kBlue, 0.2f, kBlue, 1, 1.5f}};
  expectGood(list, "polygon");  // 0.10
}

TEST_F(EdgeErrorTest, IsSmallForSeams) {
  DrawList list = fromAbove();
  const mat3 axes = turned(0.7f, 0.5f, 0.3f);
  list.ellipsoids.push_back({vec3(0), axes, {kGreen, 0.3f}});
  addAxes(list, axes);
  expectGood(list, "axes leave an ellipsoid");  // 0.96

  list = fromAbove();
  list.boxes.push_back({vec3(0), axes, {kGreen, 0.3f}});
  addAxes(list, axes);
  expectGood(list, "axes leave a box");  // 0.45

  list = fromAbove();
  list.ellipsoids.push_back({{0, -0.3f, 0}, turned(0.6f, 0.5f, 0.4f), {kGreen, 0.3f}});
  list.ellipsoids.push_back({{0.1f, 0.3f, 0}, turned(0.4f, 0.5f, 0.6f), {kBlue, 0.3f}});
  list.frustums.push_back({{0.3f, -0.3f, -0.3f}, {0.3f, 0.5f, 0.4f}, 0.25f, 0.25f, {kVermilion, 0.3f}});
  expectGood(list, "solids cut each other");  // 1.13

  list = fromAbove();
  list.boxes.push_back({{0, -0.2f, 0}, axes, {kGreen, 0.3f}});
  list.ellipsoids.push_back({{0.1f, 0.3f, 0}, turned(0.4f, 0.5f, 0.6f), {kBlue, 0.3f}});
  expectGood(list, "ellipsoid cuts a box");  // 0.53
}

// The picture of a film: plane, glass, body, vectors, polhode and herpolhode.
TEST_F(EdgeErrorTest, IsSmallForPoinsotsConstruction) {
  DrawList list = fromAbove();
  const mat3 glass = turned(0.8f, 0.55f, 0.4f);
  list.planes = {gridAt(-0.5f, 0.95f)};
  list.glassEllipsoids = {glassOf(glass, true)};
  list.boxes.push_back({vec3(0), turned(0.15f, 0.3f, 0.45f), {kGreen, 0.3f}});
  addAxes(list, turned(0.2f, 0.35f, 0.5f));
  addArrow(list, vec3(0), {0, 0, 0.9f}, 0.02f, kBlue);
  addArrow(list, vec3(0), {0.1f, 0.3f, -0.5f}, 0.02f, kVermilion);
  list.ellipsoids.push_back({{0.1f, 0.3f, -0.5f}, mat3(0.03f), {kInk, 0.3f}});
  list.curves.push_back(ringOf(glass, 0.8f, 2, kVermilion, 0.01f));
  list.curves.push_back(ringOf({0.55f, 0, 0, 0, 0.55f, 0, 0, 0, 0.1f}, 0.0f, 2, kOrange, 0.01f));
  for (vec3& p : list.curves.back().points_V) p.z -= 0.5f;
  expectGood(list, "Poinsot's construction");  // 1.19
  list.camera = draw::orthographic(list.camera, vec3(0));
  expectGood(list, "parallel rays");  // 1.21
}

}  // namespace
}  // namespace poinsot::render
