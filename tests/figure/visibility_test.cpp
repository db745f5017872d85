// SPDX-License-Identifier: Apache-2.0
#include "figure/visibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <random>

namespace poinsot::figure {
namespace {

/// Returns an empty list, seen from 10 away along x.
draw::DrawList emptyList() {
  draw::DrawList list;
  list.camera = draw::lookAt({10, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0.6f, {600, 400});
  list.camera.near = 1;
  list.camera.far = 100;
  return list;
}

draw::Ellipsoid ellipsoid(glm::vec3 centre_V, const glm::mat3& semiAxes_V) {
  return {centre_V, semiAxes_V, {}, {}, 0};
}
draw::Box box(glm::vec3 centre_V, const glm::mat3& halfAxes_V) { return {centre_V, halfAxes_V, {}}; }
draw::Mesh placed(std::shared_ptr<const draw::TriangleMesh> mesh, glm::vec3 origin_V, const glm::mat3& axes_V) {
  draw::Mesh result;
  result.mesh = std::move(mesh);
  result.origin_V = origin_V;
  result.axes_V = axes_V;
  return result;
}

/// Returns a plane that faces the eye and extends by 1 to either side.
draw::GridPlane tinted(glm::vec3 centre_V, draw::Color color, float opacity) {
  draw::GridPlane plane;
  plane.centre_V = centre_V;
  plane.u_V = {0, 1, 0};
  plane.v_V = {0, 0, 1};
  plane.color = color;
  plane.opacity = opacity;
  return plane;
}

class Random {
 public:
  double between(double a, double b) { return a + (b - a) * static_cast<double>(engine_()) / 4294967295.0; }
  glm::dvec3 inCube(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }

 private:
  std::mt19937 engine_{7};
};

// ---- solids, compared with points that are tried one by one along the line of sight

using Inside = std::function<bool(glm::dvec3 p_V)>;

bool insideOnTheWay(const draw::DrawList& list, const Inside& inside, glm::dvec3 p_V, int steps) {
  const glm::dvec3 eye_V = list.camera.eye_V;
  for (int i = 0; i < steps; ++i)
    if (inside(glm::mix(eye_V, p_V, static_cast<double>(i) / steps))) return true;
  return false;
}

/// Checks points around and behind a solid at the origin. A point must be hidden if the samples meet the solid. If
/// a point is hidden and 2000 samples miss the solid, an edge is grazed, which 100 times as many samples meet.
void expectHides(const draw::DrawList& list, const Inside& inside) {
  const Visibility visibility(list);
  Random random;
  int hidden = 0;
  for (int i = 0; i < 600; ++i) {
    const glm::dvec3 p_V = random.inCube(2.5);
    const bool met = insideOnTheWay(list, inside, p_V, 2000);
    const bool hides = visibility.of(p_V).hidden;
    if (hides != met) {
      EXPECT_EQ(hides, insideOnTheWay(list, inside, p_V, 200000)) << p_V.x << ' ' << p_V.y << ' ' << p_V.z;
    }
    hidden += hides;
  }
  EXPECT_GT(hidden, 30);
  EXPECT_LT(hidden, 570);
}

const glm::mat3 kSkewed{{1.2f, 0.3f, -0.2f}, {-0.4f, 0.9f, 0.5f}, {0.1f, -0.3f, 0.8f}};

TEST(Visibility, EllipsoidsHidePointsBehindThem) {
  draw::DrawList list = emptyList();
  list.ellipsoids.push_back(ellipsoid({0.2f, -0.1f, 0.3f}, kSkewed));
  const glm::dmat3 toSphere = glm::inverse(glm::dmat3(kSkewed));
  expectHides(list, [&](glm::dvec3 p) { return glm::length(toSphere * (p - glm::dvec3(0.2, -0.1, 0.3))) < 1; });
}

TEST(Visibility, BoxesHidePointsBehindThem) {
  draw::DrawList list = emptyList();
  list.boxes.push_back(box({0.2f, -0.1f, 0.3f}, kSkewed));
  const glm::dmat3 toCube = glm::inverse(glm::dmat3(kSkewed));
  expectHides(list, [&](glm::dvec3 p) {
    const glm::dvec3 q = glm::abs(toCube * (p - glm::dvec3(0.2, -0.1, 0.3)));
    return q.x < 1 && q.y < 1 && q.z < 1;
  });
}

Inside insideFrustum(const draw::Frustum& f) {
  const glm::dvec3 from = f.from_V, along = glm::dvec3(f.to_V) - from;
  return [=](glm::dvec3 p) {
    const double share = glm::dot(p - from, along) / glm::dot(along, along);
    const double radius = glm::mix(static_cast<double>(f.fromRadius), static_cast<double>(f.toRadius), share);
    return share > 0 && share < 1 && glm::distance(p, from + share * along) < radius;
  };
}

TEST(Visibility, FrustumsHidePointsBehindThem) {
  const draw::Frustum kinds[] = {{{0, -0.5f, -1}, {0.3f, 0.5f, 1}, 0.8f, 0.8f, {}},
                                 {{0, -0.5f, -1}, {0.3f, 0.5f, 1}, 1.1f, 0.0f, {}},
                                 {{-1, 0.2f, -0.1f}, {1, 0.1f, 0}, 0.4f, 1.2f, {}},
                                 {{1, 0.2f, -0.1f}, {-1, 0.1f, 0}, 0.0f, 1.2f, {}}};
  for (const draw::Frustum& f : kinds) {
    draw::DrawList list = emptyList();
    list.frustums.push_back(f);
    expectHides(list, insideFrustum(f));
  }
}

TEST(Visibility, MeshesHidePointsBehindThem) {
  auto octahedron = std::make_shared<draw::TriangleMesh>();
  octahedron->vertices_M = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  octahedron->triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  draw::DrawList list = emptyList();
  list.meshes.push_back(placed(octahedron, {0.2f, -0.1f, 0.3f}, 1.5f * kSkewed));
  const glm::dmat3 toMesh = glm::inverse(1.5 * glm::dmat3(kSkewed));
  expectHides(list, [&](glm::dvec3 p) {
    const glm::dvec3 q = glm::abs(toMesh * (p - glm::dvec3(0.2, -0.1, 0.3)));
    return q.x + q.y + q.z < 1;
  });
}

TEST(Visibility, TubesHidePointsBehindThem) {
  draw::Curve tube;
  for (int i = 0; i < 40; ++i) {
    const float a = 0.16f * static_cast<float>(i);
    tube.points_V.push_back({1.3f * std::cos(a), 1.2f * std::sin(a), 0.02f * static_cast<float>(i) - 0.5f});
  }
  tube.radius_V = 0.35f;
  draw::DrawList list = emptyList();
  list.curves.push_back(tube);
  expectHides(list, [&](glm::dvec3 p) {
    for (std::size_t i = 0; i + 1 < tube.points_V.size(); ++i) {
      const draw::Frustum piece{tube.points_V[i], tube.points_V[i + 1], 0.35f, 0.35f, {}};
      if (insideFrustum(piece)(p)) return true;
      if (i > 0 && glm::distance(p, glm::dvec3(tube.points_V[i])) < 0.35f) return true;
    }
    return false;
  });
}

TEST(Visibility, NoLineOfSightSlipsThroughTheSeamsOfAMesh) {
  // A square of 40 x 40 cells is seen exactly along edges and through corners.
  auto sheet = std::make_shared<draw::TriangleMesh>();
  constexpr std::uint32_t kCells = 40;
  for (std::uint32_t i = 0; i <= kCells; ++i)
    for (std::uint32_t j = 0; j <= kCells; ++j)
      sheet->vertices_M.push_back({0, static_cast<float>(i) / 20.0f - 1, static_cast<float>(j) / 20.0f - 1});
  for (std::uint32_t i = 0; i < kCells; ++i)
    for (std::uint32_t j = 0; j < kCells; ++j) {
      const std::uint32_t a = i * (kCells + 1) + j, b = a + kCells + 1;
      sheet->triangles.push_back({a, b, b + 1});
      sheet->triangles.push_back({a, b + 1, a + 1});
    }
  draw::DrawList list = emptyList();
  list.meshes.push_back(placed(sheet, glm::vec3(0), glm::mat3(1)));
  const Visibility visibility(list);
  for (std::size_t k = 0; k < sheet->vertices_M.size(); ++k) {
    const glm::dvec3 v = sheet->vertices_M[k], eye_V = list.camera.eye_V;
    if (std::max(std::abs(v.y), std::abs(v.z)) > 0.99) continue;
    EXPECT_TRUE(visibility.of(eye_V + 1.3 * (v - eye_V)).hidden) << k;
  }
}

// ---- what counts as in front

TEST(Visibility, PointsOnASurfaceAreSeenOnTheNearSideOnly) {
  draw::DrawList list = emptyList();
  list.ellipsoids.push_back(ellipsoid({0, 0, 0}, glm::mat3(1)));
  const Visibility visibility(list);
  EXPECT_FALSE(visibility.of({1, 0, 0}).hidden);
  EXPECT_TRUE(visibility.of({-1, 0, 0}).hidden);
  EXPECT_TRUE(visibility.of({0, 0, 0}).hidden);
}

TEST(Visibility, ALiftedPointIsNotHiddenByItsSurface) {
  draw::DrawList list = emptyList();
  list.ellipsoids.push_back(ellipsoid({0, 0, 0}, glm::mat3(1)));
  const Visibility visibility(list);
  EXPECT_TRUE(visibility.of({0.99, 0, 0}, 0.009).hidden);
  EXPECT_FALSE(visibility.of({0.99, 0, 0}, 0.011).hidden);
}

TEST(Visibility, SolidsTooNearToBeDrawnHideNothing) {
  draw::DrawList list = emptyList();
  list.ellipsoids.push_back(ellipsoid({9, 0, 0}, glm::mat3(0.5f)));
  list.boxes.push_back(box({9, 0, 0}, glm::mat3(0.5f)));
  list.frustums.push_back({{9, 0, 0}, {8, 0, 0}, 0.5f, 0.5f, {}});
  list.glassEllipsoids.emplace_back();
  list.glassEllipsoids[0].centre_V = {9, 0, 0};
  list.glassEllipsoids[0].semiAxes_V = glm::mat3(0.5f);
  list.planes.push_back(tinted({9.5f, 0, 0}, {0, 1, 0}, 0.5f));
  const Sight sight = Visibility(list).of({0, 0, 0});
  EXPECT_FALSE(sight.hidden);
  EXPECT_EQ(sight.transmittance, 1);
}

// ---- sheets

/// Returns glass that is as opaque at its rim as flat-on, so that its opacity does not depend on the angle.
draw::GlassEllipsoid evenGlass() {
  draw::GlassEllipsoid glass;
  glass.color = {0.2f, 0.4f, 0.8f};
  glass.nearOpacity = glass.farOpacity = glass.rimOpacity = 0.25f;
  return glass;
}

TEST(Visibility, GlassDimsAndTintsByTheSheetsInFront) {
  draw::DrawList list = emptyList();
  list.glassEllipsoids.push_back(evenGlass());
  const Visibility visibility(list);
  const Sight before = visibility.of({1.5, 0, 0}), inside = visibility.of({0, 0.2, 0}),
              behind = visibility.of({-2, 0.2, 0}), beside = visibility.of({0, 1.2, 0});
  EXPECT_EQ(before.transmittance, 1);
  EXPECT_EQ(beside.transmittance, 1);
  EXPECT_DOUBLE_EQ(inside.transmittance, 0.75);
  EXPECT_DOUBLE_EQ(behind.transmittance, 0.75 * 0.75);
  EXPECT_NEAR(inside.veil.b, 0.25 * 0.8, 1e-7);
  EXPECT_NEAR(behind.veil.r, 0.25 * 0.2 + 0.75 * 0.25 * 0.2, 1e-7);
  EXPECT_NE(before.sheets, inside.sheets);
  EXPECT_NE(inside.sheets, behind.sheets);
  EXPECT_EQ(before.sheets, beside.sheets);
}

TEST(Visibility, APlaneDimsPointsBehindItMoreInItsShadow) {
  draw::DrawList list = emptyList();
  draw::GridPlane plane = tinted({0, 0, 0}, {1, 1, 1}, 0.12f);
  plane.v_V = {0, 0, 2};
  plane.shadowRadius_V = 0.5f;
  plane.shadowOpacity = 0.5f;
  list.planes.push_back(plane);
  const Visibility visibility(list);
  // The line of sight passes (0, 0.9, 1.8), which is 3.7 shadow radii out and beyond the shadow.
  EXPECT_NEAR(visibility.of({-10, 1.8, 3.6}).transmittance, 0.88, 1e-6);
  EXPECT_EQ(visibility.of({-10, 2.2, 3.6}).transmittance, 1);
  EXPECT_EQ(visibility.of({-10, 1.8, 4.2}).transmittance, 1);
  EXPECT_EQ(visibility.of({2, 0, 0}).transmittance, 1);
  EXPECT_NEAR(visibility.of({-2, 0, 0}).transmittance, 0.88 * (1 - 0.5 * (1 - 1.0 / 512)), 1e-6);
  // The line of sight passes (0, 0.5, 0), one radius out.
  EXPECT_NEAR(visibility.of({-10, 1, 0}).transmittance, 0.88 * (1 - 0.5 * (0.25 - 1.0 / 512)), 1e-6);
}

TEST(Visibility, TheNearerOfTwoSheetsTintsMore) {
  draw::DrawList list = emptyList();
  list.planes.push_back(tinted({-1, 0, 0}, {1, 0, 0}, 0.5f));
  list.planes.push_back(tinted({1, 0, 0}, {0, 1, 0}, 0.5f));
  const Sight sight = Visibility(list).of({-3, 0, 0});
  EXPECT_DOUBLE_EQ(sight.veil.g, 0.5);
  EXPECT_DOUBLE_EQ(sight.veil.r, 0.25);
  EXPECT_DOUBLE_EQ(sight.transmittance, 0.25);
}

// The cone opens along -z under its apex at (0, 0, 1) and has radius 1 at z = 0. Its rim is as opaque as its
// sheets flat-on.
TEST(Visibility, AConeDimsLikeTwoSheets) {
  draw::DrawList list = emptyList();
  draw::GlassCone cone;
  cone.apex_V = {0, 0, 1};
  cone.axis_V = {0, 0, -3};
  cone.halfAngle_rad = 0.7853981634f;
  cone.height_V = 2;
  cone.nearOpacity = 0.25f;
  cone.farOpacity = cone.rimOpacity = 0.25f;
  list.glassCones.push_back(cone);
  const Visibility visibility(list);
  EXPECT_DOUBLE_EQ(visibility.of({1.1, 0, 0}).transmittance, 1);
  EXPECT_DOUBLE_EQ(visibility.of({0.9, 0, 0}).transmittance, 0.75);
  EXPECT_DOUBLE_EQ(visibility.of({-0.9, 0, 0}).transmittance, 0.75);
  EXPECT_DOUBLE_EQ(visibility.of({-1.1, 0, 0}).transmittance, 0.75 * 0.75);
  EXPECT_DOUBLE_EQ(visibility.of({-1, 0, 1.3}).transmittance, 1);  // over the apex: no second half
  EXPECT_DOUBLE_EQ(visibility.of({-3, 0, -2}).transmittance, 1);   // under the base
}

TEST(Visibility, APolygonDimsLikeASheetInsideItsEdges) {
  for (const bool turned : {false, true}) {
    draw::DrawList list = emptyList();
    draw::GlassPolygon triangle;
    triangle.corners_V = {{0, -1, 0}, {0, 1, 0}, {0, 0, 1}};
    if (turned) std::swap(triangle.corners_V[0], triangle.corners_V[1]);
    triangle.opacity = 0.5f;
    list.glassPolygons.push_back(triangle);
    const Visibility visibility(list);
    EXPECT_EQ(visibility.of({-0.01, 0, 0.5}).transmittance, 0.5);
    EXPECT_EQ(visibility.of({0.01, 0, 0.5}).transmittance, 1);
    EXPECT_EQ(visibility.of({-0.01, 0.6, 0.5}).transmittance, 1);
    EXPECT_EQ(visibility.of({-0.01, 0, -0.1}).transmittance, 1);
  }
}

// ---- parallel rays

// A very long lens sees what parallel rays see. Expected: the perspective above.
TEST(Visibility, ParallelProjectionMatchesADistantCamera) {
  draw::DrawList list = emptyList();
  list.ellipsoids.push_back(ellipsoid({0.2f, -1.1f, 0.3f}, 0.5f * kSkewed));
  list.boxes.push_back(box({-0.4f, 1.2f, 0.8f}, 0.4f * kSkewed));
  list.frustums.push_back({{0, 0.4f, -1.6f}, {0.3f, 1.3f, -0.6f}, 0.5f, 0.2f, {}});
  list.planes.push_back(tinted({0.5f, 0, 0}, {1, 0, 0}, 0.5f));
  list.glassEllipsoids.push_back(evenGlass());
  draw::GlassCone cone;
  cone.apex_V = {0, -1, -2};
  cone.rimOpacity = cone.nearOpacity = cone.farOpacity = 0.1f;
  list.glassCones.push_back(cone);
  draw::DrawList parallel = list, distant = list;
  parallel.camera = draw::orthographic(list.camera, {0, 0, 0});
  distant.camera.eye_V = {3000, 0, 0};
  const Visibility near(parallel), far(distant);
  Random random;
  int hidden = 0, dimmed = 0, differing = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 p_V = random.inCube(2);
    const Sight a = near.of(p_V), b = far.of(p_V);
    hidden += a.hidden;
    dimmed += a.transmittance < 0.9;
    differing += a.hidden != b.hidden || (!a.hidden && std::abs(a.transmittance - b.transmittance) > 1e-6);
  }
  // For the distant eye, rays within the cube are up to 2e-3 off, and a point up to 3e-3 behind a surface counts
  // as on it. Points so near to an edge or a surface may differ. Measured 6 of 2000.
  EXPECT_LE(differing, 20);
  EXPECT_GT(hidden, 100);
  EXPECT_GT(dimmed, 100);
}

}  // namespace
}  // namespace poinsot::figure
