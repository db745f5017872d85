// SPDX-License-Identifier: Apache-2.0
// Pictures of motion under gravity, torque and energy loss, checked on the draw list.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "scene_samples.h"
#include "stage/stage.h"

namespace poinsot::stage {
namespace {

using draw::DrawList;
using glm::vec2;
using glm::vec3;

constexpr glm::ivec2 kSize{960, 540};
const double kTimes[] = {0, 0.7, 3.3, 5, 9.9};
const std::string kBare =
    "[show]\nplane = false\nellipsoid = false\npolhode = false\nherpolhode = false\n"
    "contact = false\nheight = false\n";

// Returns the heavy symmetric top of the project's physics notes (2.7), with its axis tilted by 30 degrees.
scene::Scene top(const std::string& extra = kBare) {
  return scene::parseScene(
      "[body]\nprincipal_moments = [1.40625, 1.40625, 0.65625]\n[motion]\nomega_body = [0, 0, 9.15625]\n"
      "orientation = [0.9659258262890683, 0.25881904510252074, 0, 0]\n[motion.gravity]\n"
      "mgr_body = [0, 0, 2.84375]\n[time]\nspeed = 0.5\n" +
          extra,
      "top.toml");
}

const draw::Color kBlue = palette(scene::Theme::kLight).L;

vec3 tipOfL(const DrawList& list) {
  const auto head =
      std::ranges::find(list.frustums, kBlue, [](const draw::Frustum& f) { return f.material.color; });
  return head == list.frustums.end() ? vec3(0) : head->to_V;
}

bool insideFrame(const DrawList& list, vec3 p) {
  const vec2 q = project(list.camera, p);
  return q.x >= 0 && q.y >= 0 && q.x <= kSize.x && q.y <= kSize.y;
}

void expectInside(const DrawList& list, const std::string& where) {
  for (const auto& f : list.frustums) {
    EXPECT_TRUE(insideFrame(list, f.to_V)) << where;
    EXPECT_TRUE(insideFrame(list, f.from_V)) << where;
  }
  for (const auto& c : list.curves)
    for (const vec3& p : c.points_V) ASSERT_TRUE(insideFrame(list, p)) << where;
  for (const auto& b : list.boxes)
    for (int i = 0; i < 8; ++i)
      EXPECT_TRUE(
          insideFrame(list, b.centre_V + b.halfAxes_V * vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
}

TEST(DrivenStage, EverythingIsInsideTheFrameAllTheTime) {
  const scene::Scene scenes[] = {
      top(), top(kBare + "[camera]\nframe = \"body\"\n"), sample("[motion.torque]\nbody = [0, 0, 1.5]\n" + kBare),
      sample("[motion.dissipation]\nalpha = 0.02\n"), sample("[motion.drag]\nrate = 0.1\n")};
  int number = 0;
  for (const scene::Scene& scene : scenes) {
    const Stage stage(scene);
    ++number;
    for (double t = 0; t < 10; t += 0.5)
      expectInside(onlyList(stage, t, kSize), "scene " + std::to_string(number) + " at " + std::to_string(t));
  }
}

// The top's rim turns to every side. Still, the top and L must fill more than half of the picture's height.
TEST(DrivenStage, ATopStandsOnAPedestalAndFillsThePicture) {
  const Stage stage(top());
  float highest = 1e9f, lowest = -1e9f;
  for (const double t : kTimes) {
    const DrawList list = onlyList(stage, t, kSize);
    ASSERT_GE(list.frustums.size(), 2u);
    const draw::Frustum &cone = list.frustums[0], &pedestal = list.frustums[1];
    EXPECT_EQ(cone.from_V, vec3(0));  // on its apex
    EXPECT_EQ(cone.fromRadius, 0);
    EXPECT_GT(glm::normalize(cone.to_V).z, 0.7f);  // nutates between 30 and 38.84 degrees: cos >= 0.779
    EXPECT_EQ(pedestal.to_V, vec3(0));
    EXPECT_LT(pedestal.from_V.z, 0);
    highest = std::min(highest, project(list.camera, tipOfL(list)).y);
    lowest = std::max(lowest, project(list.camera, pedestal.from_V).y);
  }
  EXPECT_GT(lowest - highest, 0.5f * kSize.y);
}

// The wheel's rim is below the point of support, but to the side. The pedestal is a cone of atan(0.18/0.34) = 27.9
// degrees, so that it has room under a wheel whose axis leans by up to 62.1 degrees.
TEST(DrivenStage, ALeaningTopHasAPedestalOnlyIfThereIsRoom) {
  for (const double tilt_deg : {55.0, 70.0}) {
    const double half = tilt_deg * std::acos(-1.0) / 360;
    const std::string turn = std::to_string(std::cos(half)) + ", " + std::to_string(std::sin(half)) + ", 0, 0]\n";
    const scene::Scene wheel = scene::parseScene(
        "[body]\npivot = [0, 0, 0]\n[[body.part]]\nshape = \"cylinder\"\nradius = 0.4\nheight = 0.02\n"
        "mass = 1\noffset = [0, 0, 0.5]\n[motion]\nomega_body = [0, 0, 60]\norientation = [" +
            turn + "[motion.gravity]\ng = 1\n[time]\nspeed = 0.05\n" + kBare,
        "leaning.toml");
    const DrawList list = onlyList(Stage(wheel), 3, kSize);
    const bool pedestal = std::ranges::any_of(list.frustums, [](const draw::Frustum& f) {
      return f.to_V == vec3(0) && f.toRadius > 0 && f.from_V.z < 0;
    });
    EXPECT_EQ(pedestal, tilt_deg < 62.1) << tilt_deg;
  }
}

// A rod hung by its end swings below the pivot.
TEST(DrivenStage, AHangingBodyHasAJointAndNoPedestal) {
  const DrawList list = onlyList(Stage(scene::parseScene("[body]\nprincipal_moments = [1, 1, 0.2]\n[motion]\n"
                                                         "omega_body = [0.5, 0, 0.1]\norientation = [0, 1, 0, 0]\n"
                                                         "[motion.gravity]\nmgr_body = [0, 0, 3]\n" +
                                                             kBare,
                                                         "pendulum.toml")),
                                 0, kSize);
  ASSERT_EQ(list.ellipsoids.size(), 1u);
  EXPECT_EQ(list.ellipsoids[0].centre_V, vec3(0));
  for (const auto& f : list.frustums) EXPECT_FALSE(f.fromRadius == f.toRadius && f.fromRadius > 0.1f);
}

// Under a constant torque N in space along z, L = L0 + N t. The arrow is to scale with its longest, at the end.
TEST(DrivenStage, TheArrowOfLGrowsWithL) {
  const Stage stage(
      sample("orientation = [1, 0, 0, 0]\n[motion.torque]\nspace = [0, 0, 2]\n[time]\nspeed = 1\n"
             "duration = 10\n" +
             kBare));
  const float atEnd = tipOfL(onlyList(stage, 10, kSize)).z;
  for (const double t : kTimes) {
    const double share = (6.4 + 2 * t) / 26.4;
    EXPECT_NEAR(tipOfL(onlyList(stage, t, kSize)).z / atEnd, share, 1e-5) << t;
  }
}

// While energy is lost at constant L, the ellipsoid shrinks and its plane comes nearer. Both touch at the tip of
// omega all the time.
TEST(DrivenStage, TheConstructionFollowsTheEnergyLoss) {
  const Stage stage(sample("[motion.dissipation]\nalpha = 0.02\n[time]\nspeed = 1\n"));
  float height = 1e9f, size = 1e9f;
  for (const double t : kTimes) {
    const DrawList list = onlyList(stage, t, kSize);
    const vec3 contact = list.ellipsoids.at(0).centre_V;
    const auto& plane = list.planes.at(0);
    EXPECT_NEAR(contact.z, plane.centre_V.z, 1e-6) << t;
    const glm::mat3 A = list.glassEllipsoids.at(0).semiAxes_V;
    const vec3 onSphere = glm::inverse(A) * contact;
    EXPECT_NEAR(glm::length(onSphere), 1, 2e-6) << t;
    const vec3 normal = glm::normalize(glm::transpose(glm::inverse(A)) * onSphere);
    EXPECT_NEAR(normal.z, -1, 2e-6) << t;
    EXPECT_LT(-plane.centre_V.z, height) << t;
    EXPECT_LT(glm::length(A[0]), size) << t;
    height = -plane.centre_V.z;
    size = glm::length(A[0]);
  }
}

}  // namespace
}  // namespace poinsot::stage
