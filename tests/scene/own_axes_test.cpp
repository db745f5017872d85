// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "scene/body_matrix.h"
#include "scene_testing.h"

// Axes of one's own, the matrices of a body in notes, and a body that is thrown by a reference point.

namespace poinsot::scene {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using ::testing::HasSubstr;

const std::string kTensor =
    "[motion]\nomega_body = [0, 0, 1]\n[body]\ninertia = [[2, 1, 0], [1, 2, 0], [0, 0, 3]]\n";
const std::string kPoints =
    "[[body.point_mass]]\nmass = 0.5\nposition = [0, 0, 0]\n[[body.point_mass]]\nmass = 0.25\nposition = [0.8, 0, "
    "0]\n[[body.point_mass]]\nmass = 0.25\nposition = [0, 0, 0.4]\n[motion]\nomega_body = [0, 4, 0]\n";

Scene parsed(const std::string& text) { return parseScene(text, "s.toml"); }

Matrix3d rows(double a, double b, double c, double d, double e, double f, double g, double h, double i) {
  return (Matrix3d() << a, b, c, d, e, f, g, h, i).finished();
}

// The axes are turned by 45 degrees about z, in each of the three ways.
TEST(OwnAxes, AreGivenInThreeWays) {
  const double half = std::sqrt(0.5);
  for (const char* way : {"rotation = [0.9238795325112867, 0, 0, 0.3826834323650898]",
                          "roll_pitch_yaw = [0, 0, '45 deg']", "x = [3, 3, 0]\ny = [0, 2, 0]"}) {
    const Body body = parsed(kTensor + "[body.own_axes]\n" + way + "\n").body;
    const Matrix3d U = bodyMatrix(body, BodyMatrix::kUOwn);
    EXPECT_LE((U - rows(half, half, 0, -half, half, 0, 0, 0, 1)).norm(), 1e-15) << way;
    // Along (1, 1, 0) and (-1, 1, 0), the moments are 2 + 1 and 2 - 1.
    const Matrix3d turned = bodyMatrix(body, BodyMatrix::kInertiaOwn);
    EXPECT_LE((turned - rows(3, 0, 0, 0, 1, 0, 0, 0, 3)).norm(), 2e-15) << way;
  }
}

TEST(OwnAxes, TurnTheTensorByUFromBothSides) {
  const Body body = parsed(kTensor + "[body.own_axes]\nroll_pitch_yaw = [0.3, -0.7, 1.9]\n").body;
  const Matrix3d U = bodyMatrix(body, BodyMatrix::kUOwn), I = bodyMatrix(body, BodyMatrix::kInertia);
  EXPECT_LE((U * U.transpose() - Matrix3d::Identity()).norm(), 1e-15);
  EXPECT_LE((bodyMatrix(body, BodyMatrix::kInertiaOwn) - U * I * U.transpose()).norm(), 2e-15);
}

TEST(OwnAxes, MayTurnExactly) {
  const Body body = parsed(kTensor + "[body.own_axes]\nrotation = [1, 0, 0, 1]\n").body;
  EXPECT_EQ(bodyMatrix(body, BodyMatrix::kInertiaOwn), rows(2, -1, 0, -1, 2, 0, 0, 0, 3));
  EXPECT_EQ(parsed(kTensor).body.q_BA, std::nullopt);
}

TEST(OwnAxes, ReportMistakes) {
  const auto problem = [](const std::string& keys) { return messagesOf(kTensor + "[body.own_axes]\n" + keys); };
  EXPECT_THAT(problem(""), HasSubstr("body.own_axes: needs rotation, roll_pitch_yaw, or x and y"));
  EXPECT_THAT(problem("x = [1, 0, 0]\n"),
              HasSubstr("body.own_axes.x: one direction does not fix the axes; give body.own_axes.y too"));
  EXPECT_THAT(problem("y = [1, 0, 0]\n"), HasSubstr("give body.own_axes.x too"));
  EXPECT_THAT(problem("x = [1, 0, 0]\ny = [-2, 0, 0]\n"),
              HasSubstr("body.own_axes.y: must not be along body.own_axes.x, got (-2, 0, 0)"));
  EXPECT_THAT(problem("x = [1, 0, 0]\ny = [0, 0, 0]\n"), HasSubstr("body.own_axes.y: must not all be zero"));
  EXPECT_THAT(problem("rotation = [1, 0, 0, 0]\nroll_pitch_yaw = [0, 0, 1]\n"),
              HasSubstr("body.own_axes.roll_pitch_yaw: body.own_axes.rotation is given too"));
  EXPECT_THAT(problem("rotation = [1, 0, 0, 0]\nx = [0, 0, 1]\n"),
              HasSubstr("body.own_axes.x: body.own_axes.rotation"));
  EXPECT_THAT(messagesOf(kTensor + "[[vector]]\ncomponents = [1, 0, 0]\nframe = 'own'\n"),
              HasSubstr("vector[0].frame: \"own\" needs axes of one's own; give [body.own_axes]"));
}

// A box of 2 x 2 x 2 m and 6 kg has 4 kg m^2 about each axis. The displacement (0, 0, -1) adds 6 to two of them.
TEST(BodyMatrices, AreThoseOfTheDisplacedAxisTheorem) {
  const Body body =
      parsed("[body]\nshape = 'cube'\nedge = 2\nmass = 6\npivot = [0, 0, -1]\n[motion]\nomega_body = [0, 0, 1]\n")
          .body;
  EXPECT_EQ(bodyMatrix(body, BodyMatrix::kInertiaCentre), rows(4, 0, 0, 0, 4, 0, 0, 0, 4));
  EXPECT_EQ(bodyMatrix(body, BodyMatrix::kInertiaDisplacement), rows(6, 0, 0, 0, 6, 0, 0, 0, 0));
  EXPECT_EQ(bodyMatrix(body, BodyMatrix::kInertia), rows(10, 0, 0, 0, 10, 0, 0, 0, 4));
}

TEST(BodyMatrices, HaveThePrincipalAxesAsRowsOfU) {
  const Body body = parsed(kTensor).body;
  const Matrix3d U = bodyMatrix(body, BodyMatrix::kUPrincipal), I = bodyMatrix(body, BodyMatrix::kInertia);
  EXPECT_LE((U * I * U.transpose() - bodyMatrix(body, BodyMatrix::kInertiaPrincipal)).norm(), 2e-15);
  EXPECT_NEAR(U.determinant(), 1, 1e-15);
}

TEST(NoteOfAMatrix, NeedsABodyThatHasIt) {
  const auto problem = [](const std::string& keys) { return messagesOf(kTensor + "[[note]]\n" + keys); };
  EXPECT_EQ(problem("matrix = 'inertia'\n"), "");
  EXPECT_EQ(problem("matrix = 'U_principal'\ntext = 'U'\n"), "");
  EXPECT_THAT(problem("matrix = 'U_own'\n"), HasSubstr("note[0].matrix: \"U_own\" needs axes of one's own"));
  EXPECT_THAT(problem("matrix = 'inertia_centre'\n"),
              HasSubstr("note[0].matrix: \"inertia_centre\" needs a body with a mass"));
  EXPECT_THAT(problem("matrix = 'inertia'\ntext = ['a', 'b']\n"),
              HasSubstr("note[0].text: the name of a matrix is one line, got 2"));
  EXPECT_THAT(problem("at = 'left'\n"), HasSubstr("note[0].text: is required"));
  EXPECT_THAT(messagesOf(kPoints + "[[note]]\nmatrix = 'inertia_displacement'\n"),
              HasSubstr("needs a point other than the centre of mass; give body.pivot"));
}

// c = (0.2, 0, 0.1) leads from K to the centre of mass. omega x c = (4 * 0.1, 0, -4 * 0.2).
TEST(FlightOfAPoint, MovesTheCentreOfMass) {
  const Scene scene =
      parsed(kPoints + "[motion.flight]\npoint = [0, 0, 0]\nposition = [-1, 0, 0.2]\nvelocity = [2, 0, 3]\n");
  ASSERT_TRUE(scene.motion.flight);
  EXPECT_LE((scene.motion.flight->position_W - Vector3d(-0.8, 0, 0.3)).norm(), 1e-15);
  EXPECT_LE((scene.motion.flight->velocity_W - Vector3d(2.4, 0, 2.2)).norm(), 1e-15);
}

// A quarter turn about z takes c to (0, 0.2, 0.1), and omega to (-4, 0, 0): omega x c = (0, 0.4, -0.8).
TEST(FlightOfAPoint, TakesTheAttitudeIntoAccount) {
  const Scene scene =
      parsed(kPoints + "orientation = [1, 0, 0, 1]\n[motion.flight]\npoint = [0, 0, 0]\nvelocity = [2, 0, 3]\n");
  ASSERT_TRUE(scene.motion.flight);
  EXPECT_LE((scene.motion.flight->position_W - Vector3d(0, 0.2, 0.1)).norm(), 1e-15);
  EXPECT_LE((scene.motion.flight->velocity_W - Vector3d(2, 0.4, 2.2)).norm(), 1e-15);
}

TEST(FlightOfAPoint, ReportsMistakes) {
  EXPECT_THAT(messagesOf(kPoints + "[motion.flight]\npoint = [0, 0, 0]\n"),
              HasSubstr("motion.flight.point: needs motion.flight.velocity, the velocity of this point"));
  EXPECT_THAT(messagesOf(kTensor + "[motion.flight]\npoint = [0, 0, 0]\nvelocity = [1, 0, 0]\n"),
              HasSubstr("motion.flight.point: needs a body with a mass"));
}

}  // namespace
}  // namespace poinsot::scene
