// SPDX-License-Identifier: Apache-2.0
// Grading of logs that hold the exact motion in axes other than poinsot's.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>

#include "reference/grade_logs.h"

namespace poinsot::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using physics::RigidBodyState;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Returns the vector w of a skew matrix [w ×].
Vector3d vectorOf(const Matrix3d& skew) { return {skew(2, 1), skew(0, 2), skew(1, 0)}; }

Matrix3d skewOf(const Vector3d& w) {
  Matrix3d m;
  m << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0;
  return m;
}

/// Writes the motion in axes of either hand, along which a vector v has the components body v or space v. Matrices
/// alone give the row, without the rule for axial vectors: attitude R' = space R body^-1;
/// R'^-1 dR'/dt = [omega' ×] = body [omega ×] body^-1.
LogWriter inAxes(const Matrix3d& body, const Matrix3d& space) {
  return [=](const RigidBodyState& s) {
    const Matrix3d R = space * s.q_WB.toRotationMatrix() * body.transpose();
    return LogRow{s.t_s, Quaterniond(R), vectorOf(body * skewOf(s.omega_B) * body.transpose())};
  };
}

Matrix3d rows(const Vector3d& x, const Vector3d& y, const Vector3d& z) {
  Matrix3d m;
  m << x.transpose(), y.transpose(), z.transpose();
  return m;
}

TEST(GradeAxes, NamesCommonAxisConventions) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const auto expect = [](const Matrix3d& axes, const std::string& condition, const std::string& name) {
    for (const Holds holds : {Holds::kAttitude, Holds::kBoth}) {
      const std::string csv = logOf(inAxes(axes, axes), holds);
      expectCause(csv, condition);
      EXPECT_THAT(gradeOfLog(csv).notes, ElementsAre(HasSubstr(name)));
    }
  };
  expect(rows(x, -y, -z), "both frames are turned by 180 deg about x", "forward-right-down axes");
  expect(rows(x, -y, z), "both frames are turned by 180 deg about y",
         "left-handed axes (Unreal), as if the y axis were mirrored");
  expect(rows(x, y, -z), "both frames are turned by 180 deg about z",
         "left-handed axes (Unity), as if the z axis were mirrored");
  expect(rows(x, z, y), "both frames are turned by 180 deg about (0, 0.707, -0.707)",
         "left-handed axes with y up (Unity), as if y and z were exchanged");
  expect(rows(y, x, -z), "both frames are turned by 180 deg about (0.707, 0.707, 0)", "north-east-down");
  expect(rows(x, z, -y), "both frames are turned by 90 deg about x",
         "axes with y up; the scene's x, y, z are the log's x, -z, y");
}

TEST(GradeAxes, FindsAllPermutationsAndSignsOfAxes) {
  std::array<int, 3> order{0, 1, 2};
  int found = 0;
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Matrix3d axes = Matrix3d::Zero();
      for (int i = 0; i < 3; ++i) axes(i, order[static_cast<std::size_t>(i)]) = (signs >> i & 1) != 0 ? -1 : 1;
      if (axes.isIdentity() || (-axes).isIdentity())
        continue;  // a reflection through the origin leaves q and omega alone
      const Grade grade = gradeOfLog(logOf(inAxes(axes, axes)));
      EXPECT_LE(largestLeft(grade), 9e-15) << axes;  // measured 9.5e-16
      EXPECT_THAT(grade.notes, ElementsAre(StartsWith("fits if both frames are turned by "))) << axes;
      ++found;
    }
  } while (std::ranges::next_permutation(order).found);
  EXPECT_EQ(found, 46);
}

const Matrix3d kOblique = Eigen::AngleAxisd(0.7, Vector3d(2, -1, 2) / 3).toRotationMatrix();
const Matrix3d kQuarter = Eigen::AngleAxisd(EIGEN_PI / 2, Vector3d::UnitY()).toRotationMatrix();

TEST(GradeAxes, FitsObliqueTurnsOfBodyAndSpaceAxes) {
  const Matrix3d one = Matrix3d::Identity();
  // The log's axes are turned by the inverse; 0.7 rad = 40.11 deg. Turned body axes multiply q from the right,
  // turned space axes from the left.
  expectCause(logOf(inAxes(kOblique, kOblique)),
              "both frames are turned by 40.11 deg about (-0.667, 0.333, -0.667)");
  expectCause(logOf(inAxes(kOblique, one)),
              "the body's axes are turned by 40.11 deg about (0.667, -0.333, 0.667)");
  expectCause(logOf(inAxes(one, kOblique)),
              "the axes of space are turned by 40.11 deg about (-0.667, 0.333, -0.667)");
  for (const Holds holds : {Holds::kAttitude, Holds::kBoth}) {
    expectCause(logOf(inAxes(kQuarter.transpose(), one), holds),
                "the body's axes are turned by 90 deg about (0, -1, 0)");
    expectCause(logOf(inAxes(one, kQuarter), holds), "the axes of space are turned by 90 deg about (0, -1, 0)");
  }
  const Grade two = gradeOfLog(logOf(inAxes(kOblique, kQuarter)));
  EXPECT_LE(largestLeft(two), 1.1e-14);  // measured 1.1e-15
  EXPECT_THAT(two.notes,
              ElementsAre(AllOf(HasSubstr("the body's axes are turned by 40.11 deg"),
                                HasSubstr("and the axes of space are turned by 90 deg about (0, -1, 0)"))));
}

TEST(GradeAxes, DistinguishesAxesOfQFromAxesOfOmega) {
  const Quaterniond turn(kQuarter);
  expectCause(logOf([&](const auto& s) {
                return LogRow{s.t_s, s.q_WB, turn * s.omega_B};
              }),
              "the axes of omega are turned by 90 deg about (0, -1, 0)");
  expectCause(logOf([&](const auto& s) {
                return LogRow{s.t_s, s.q_WB * turn, s.omega_B};
              }),
              "the body's axes of q, not of omega, are turned by 90 deg about (0, -1, 0)");
}

TEST(GradeAxes, NamesAxesTogetherWithOtherCauses) {
  const Matrix3d down = rows(Vector3d::UnitX(), -Vector3d::UnitY(), -Vector3d::UnitZ());
  const Grade late = gradeOfLog(logOf([&](const auto& s) {
    LogRow row = inAxes(down, down)(s);
    row.t_s -= 0.5;
    return row;
  }));
  EXPECT_LE(largestLeft(late), 1.2e-14);
  EXPECT_THAT(late.notes, ElementsAre(AllOf(HasSubstr("forward-right-down"), HasSubstr("t is 0.5 s later"))));
  const Grade three = gradeOfLog(logOf([&](const auto& s) {
    const LogRow row = inAxes(down, down)(s);
    return LogRow{row.t_s, scalarLast(row.q), 180 / EIGEN_PI * row.omega_B};
  }));
  EXPECT_LE(largestLeft(three), 1.2e-14);
  EXPECT_THAT(three.notes, ElementsAre(AllOf(HasSubstr("hold x, y, z, w"), HasSubstr("omega is in deg/s"),
                                             HasSubstr("forward-right-down"))));
}

}  // namespace
}  // namespace poinsot::reference
