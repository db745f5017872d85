// SPDX-License-Identifier: Apache-2.0
// Messages about impossible tensors and moments suggest values, which must be accepted as printed.
#include "scene/keys/tensor_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>

#include "physics/possible_inertia.h"
#include "physics/random_bodies.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

const std::string kStart = "motion.omega_body = [0.1, 0.2, 1]\n";

std::string problems(const std::string& body) { return messagesOf(kStart + body); }

/// Returns the value after these words of a message, to the end of its brackets.
std::string valueAfter(const std::string& message, const std::string& words, const std::string& closing) {
  const auto begin = message.find(words);
  if (begin == std::string::npos) return "no \"" + words + "\" in " + message;
  const auto from = begin + words.size();
  return message.substr(from, message.find(closing, from) + closing.size() - from);
}

Matrix3d tensorOf(const std::string& rows) {
  return parseScene(kStart + "body.inertia=" + rows, "test.toml").body.axes.inertia_B();
}

TEST(TensorLayout, SuggestsBothOrdersForSixNumbers) {
  const std::string message = problems("body.inertia=[2, 0.1, 0.2, 3, '0.3 kg m^2', 4]");
  EXPECT_EQ(message,
            "body.inertia: expected three rows [[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]] of moments of "
            "inertia, "
            "got an array of 6; for the order ixx, ixy, ixz, iyy, iyz, izz (URDF, Gazebo) write [[2, 0.1, 0.2], "
            "[0.1, 3, "
            "\"0.3 kg m^2\"], [0.2, \"0.3 kg m^2\", 4]]; for the order ixx, iyy, izz, ixy, ixz, iyz (MuJoCo's "
            "fullinertia) "
            "write [[2, 3, \"0.3 kg m^2\"], [3, 0.1, 4], [\"0.3 kg m^2\", 4, 0.2]]\n");
  EXPECT_EQ(problems("body.inertia=" + valueAfter(message, "Gazebo) write ", "]]")), "");
}

// The same body is given in several layouts. Each message must suggest that body.
TEST(TensorLayout, SuggestsTheTensorForOtherLayouts) {
  const Matrix3d expected = tensorOf("[[2, 0.1, 0.2], [0.1, 3, 0.3], [0.2, 0.3, 4]]");
  for (const char* given : {"[2, 0.1, 0.2, 0.1, 3, 0.3, 0.2, 0.3, 4]", "[[2, 0.1, 0.2], [3, 0.3], [4]]",
                            "[[2], [0.1, 3], [0.2, 0.3, 4]]", "[[2, 0.1, 0.2], [0, 3, 0.3], [0, 0, 4]]",
                            "[[2, 0, 0], [0.1, 3, 0], [0.2, 0.3, 4]]"}) {
    const std::string message = problems(std::string("body.inertia=") + given);
    EXPECT_EQ(tensorOf(valueAfter(message, "write ", "]]")), expected) << message;
  }
  EXPECT_THAT(problems("body.inertia=[2, 3, 4]"),
              HasSubstr("; for a diagonal tensor write [[2, 0, 0], [0, 3, 0], [0, "
                        "0, 4]], or principal_moments = [2, 3, 4]\n"));
}

TEST(TensorLayout, SuggestsNothingForUnknownLayouts) {
  for (const char* given :
       {"[1, 2]", "[]", "3", "'a'", "[[1, 2], [3, 4]]", "[[1, 2, 3], [4, 5, 6], [7, 8, 9, 10]]",
        "[1, 2, 3, 4, 5, true]", "[[2, 1, 0], [1.5, 2, 0], [0, 0, 2]]"}) {
    const std::string message = problems(std::string("body.inertia=") + given);
    EXPECT_THAT(message, HasSubstr("body.inertia: ")) << given;
    EXPECT_EQ(message.find("write ["), std::string::npos) << message;
  }
}

TEST(TensorLayout, SuggestsKeysForNamesOfOtherPrograms) {
  EXPECT_THAT(problems("body.ixx=2"), HasSubstr("body.ixx: unknown key; did you mean body.inertia?"));
  EXPECT_THAT(problems("body.fullinertia=[1, 1, 1, 0, 0, 0]"), HasSubstr("did you mean body.inertia?"));
  EXPECT_THAT(problems("body.diaginertia=[1, 1, 1]"), HasSubstr("did you mean body.principal_moments?"));
}

TEST(ImpossibleMoments, MessageNamesTheMomentThatIsTooLarge) {
  EXPECT_THAT(problems("body.principal_moments=[9, 1, 1]"), HasSubstr("I1 must not exceed I2 + I3"));
  EXPECT_THAT(problems("body.principal_moments=[1, 9, 1]"), HasSubstr("I2 must not exceed I1 + I3"));
  EXPECT_EQ(problems("body.principal_moments=[1, 3, 2]"), "");  // a lamina is a body
}

// Worked by hand: (1, 2, 4) violates the inequality by 1; each moment changes by a third of that.
TEST(ImpossibleMoments, MessageGivesNearestMoments) {
  EXPECT_EQ(
      problems("body.principal_moments=[1, 2, 4]"),
      "body.principal_moments: I3 must not exceed I1 + I2, got (1, 2, 4) kg·m²; a solid body cannot have these "
      "values; the nearest possible moments in kg·m² are [1.333333333333, 2.333333333333, 3.666666666667]\n");
  EXPECT_THAT(problems("body.principal_moments=[1, '-1 kg m^2', 1.5]"),
              AllOf(HasSubstr("must be positive"),
                    HasSubstr("got \"-1 kg m^2\"; the nearest possible moments in kg·m² are [1.25, "
                              "1.25e-06, 1.25]\n")));
  EXPECT_EQ(problems("body.principal_moments=[-1, -2, -3]").find("nearest"), std::string::npos);
}

TEST(ImpossibleMoments, SuggestedMomentsAreAccepted) {
  physics::Draw draw(81);
  int pasted = 0;
  for (int i = 0; i < 300; ++i) {
    const double size = draw.decade(-47, 20);
    const Vector3d given = size * Vector3d(draw.between(-0.2, 1), draw.between(0.01, 1), draw.between(0.01, 3));
    const std::string message =
        problems(fmt::format("body.principal_moments=[{}, {}, {}]", given[0], given[1], given[2]));
    if (message.empty()) continue;
    const std::string paste = valueAfter(message, "the nearest possible moments in kg·m² are ", "]");
    ASSERT_EQ(problems("body.principal_moments=" + paste), "") << message;
    const Vector3d read =
        parseScene(kStart + "body.principal_moments=" + paste, "test.toml").body.axes.moments().values();
    EXPECT_LE((read - *physics::nearestPossibleMoments(given)).norm(),
              1e-5 * read.norm());  // six digits; measured 5e-6
    ++pasted;
  }
  EXPECT_GT(pasted, 100);
}

TEST(ImpossibleTensor, SuggestedTensorIsAccepted) {
  physics::Draw draw(82);
  int pasted = 0;
  for (int i = 0; i < 300; ++i) {
    const double size = draw.decade(-40, 20);
    std::array<double, 6> e{};
    for (double& entry : e) entry = size * draw.between(-0.5, 1);
    e[0] = std::abs(e[0]) + size;
    const std::string message = problems(fmt::format(
        "body.inertia=[[{0}, {1}, {2}], [{1}, {3}, {4}], [{2}, {4}, {5}]]", e[0], e[1], e[2], e[3], e[4], e[5]));
    if (message.empty()) continue;
    const std::string paste = valueAfter(message, "the nearest possible tensor in kg·m² is ", "]]");
    ASSERT_EQ(problems("body.inertia=" + paste), "") << message;
    Matrix3d given;
    given << e[0], e[1], e[2], e[1], e[3], e[4], e[2], e[4], e[5];
    EXPECT_LE((tensorOf(paste) - *physics::nearestPossibleTensor(given)).norm(), 1e-5 * size);  // measured 3.2e-6
    ++pasted;
  }
  EXPECT_GT(pasted, 100);
}

// Worked by hand: 2 on the diagonal and s off it give the moments 2 + 2 s, 2 - s and 2 - s: 3.8, 1.1, 1.1 and
// 0.2, 2.9, 2.9.
TEST(ImpossibleTensor, MessageSuggestsAChangeOfSignIfThatHelps) {
  EXPECT_THAT(problems("body.inertia=[[2, 0.9, 0.9], [0.9, 2, 0.9], [0.9, 0.9, 2]]"),
              EndsWith("; the tensor is possible if its products of inertia change sign (an off-diagonal element "
                       "is -(sum of m x y))\n"));
  EXPECT_EQ(problems("body.inertia=[[1, 0, 0], [0, 1, 0], [0, 0, 3]]").find("change sign"), std::string::npos);
}

}  // namespace
}  // namespace poinsot::scene
