// SPDX-License-Identifier: Apache-2.0
// Arrays of tables, such as [[body.part]].
#include <gmock/gmock.h>

#include "scene/limits.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using testing::HasSubstr;

const std::string kParts =
    "motion.omega_body = [1, 0, 0]\n"
    "[[body.part]]\nshape = 'cube'\nedge = 1\nmass = 1\n"
    "[[body.part]]\nshape = 'cube'\nedge = 2\nmass = 3\n";

Body bodyWith(const std::vector<std::string>& overrides) {
  return parseScene(kParts, "test.toml", overrides).body;
}

TEST(Arrays, OverridesSelectElementsByTheirNumber) {
  EXPECT_EQ(bodyWith({}).mass->mass_kg(), 4);
  EXPECT_EQ(bodyWith({"body.part[1].mass=10"}).mass->mass_kg(), 11);
  EXPECT_EQ(bodyWith({"body.part[0].offset=[0, 0, 1]"}).parts[0].offset_B.z(), 1);
}

TEST(Arrays, OverridesMayReplaceTheWholeArray) {
  EXPECT_EQ(bodyWith({"body.part=[{shape='sphere', radius=1, mass=7}]"}).mass->mass_kg(), 7);
  EXPECT_THAT(messagesOf(kParts, {"body.part=[]"}), HasSubstr("body: the body is missing"));
}

TEST(Arrays, ProblemsPointAtTheElement) {
  const auto found = problemsOf(kParts + "[[body.part]]\nshape = 'cube'\nmass = 2\nofset = 2\nedge = -1\n");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(core::toString(found[0].where), "test.toml:13:1");
  EXPECT_EQ(
      found[0].message,
      "body.part[2].ofset: unknown key; did you mean body.part[2].offset? For example:\n    offset = [0, 0, 2]");
  EXPECT_EQ(core::toString(found[1].where), "test.toml:14:8");
  EXPECT_THAT(found[1].message, HasSubstr("body.part[2].edge: must be positive"));
}

TEST(Arrays, MissingKeysAreReportedWhereTheElementBegins) {
  const auto found = problemsOf(kParts + "[[body.part]]\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].where.line, 10);
  EXPECT_EQ(found[0].message, "body.part[2]: body.part[2].shape is missing");
}

TEST(Arrays, RejectOverridesOfMissingElements) {
  EXPECT_EQ(messagesOf(kParts, {"body.part[2].mass=1"}),
            "body.part[2].mass: there is no such element; the scene has 2 of [[body.part]], counted from 0\n");
  EXPECT_EQ(messagesOf(kParts, {"body.part.mass=1"}),
            "body.part.mass: [[body.part]] is an array of tables; name one by its number from 0, such as "
            "body.part[0]\n");
  EXPECT_EQ(messagesOf(kParts, {"body.part[].mass=1"}),
            "body.part[].mass: [[body.part]] is an array of tables; name one by its number from 0, such as "
            "body.part[0]\n");
  EXPECT_EQ(messagesOf(kParts, {"body.part[0].mas=1"}),
            "body.part[0].mas: unknown key; did you mean body.part[0].mass?\n");
  for (const char* path : {"body.part[-1].mass=1", "body.part[x].mass=1", "body.part[0.mass=1", "body[0].mass=1",
                           "body.part[0][0].mass=1", "body.part[99999999999999999999].mass=1", "time[0].fps=1"})
    EXPECT_NE(messagesOf(kParts, {path}), "") << path;
}

TEST(Arrays, RejectValuesThatAreNotTables) {
  EXPECT_THAT(messagesOf("body.part = 3\n"),
              HasSubstr("body.part: expected an array of tables, each begun with [[body.part]], got 3"));
  EXPECT_THAT(messagesOf("body.part = [1]\n"), HasSubstr("body.part: expected an array of tables"));
  EXPECT_THAT(messagesOf("[body.part]\nmass = 1\n"), HasSubstr("got a table"));
  EXPECT_THAT(messagesOf("body.prat = [{mass = 1}]\n"),
              HasSubstr("body.prat: unknown key; did you mean body.part?"));
  EXPECT_THAT(messagesOf("body.'part[0]' = 1\n"), HasSubstr("unknown key"));
}

TEST(Arrays, HaveALimitedNumberOfElements) {
  std::string points = "motion.omega_body = [1, 0, 0]\n";
  for (std::size_t i = 0; i < static_cast<std::size_t>(rowOf(Limit::kElements).usual); ++i) {
    const std::string n = std::to_string(i);
    points += "[[body.point_mass]]\nmass = 1\nposition = [" + n + ", " + std::to_string(i % 7) + ", 1]\n";
  }
  EXPECT_EQ(messagesOf(points), "");
  EXPECT_THAT(messagesOf(points + "[[body.point_mass]]\nmass = 1\nposition = [0, 0, 0]\n"),
              HasSubstr("body.point_mass: may have at most 10000 elements, got 10001"));
}

}  // namespace
}  // namespace poinsot::scene
