// SPDX-License-Identifier: Apache-2.0
// Points that a figure for LaTeX names: tips of arrows, the centre of mass, the pivot, the point of contact.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <map>

#include "scene_samples.h"
#include "stage/figures/point_name.h"
#include "stage/stage.h"

namespace poinsot::stage {
namespace {

using testing::IsSupersetOf;
using testing::UnorderedElementsAre;

constexpr glm::ivec2 kSize(480, 270);

draw::DrawList listOf(const std::string& text, double filmTime_s = 1) {
  return Stage(scene::parseScene(text, "sample.toml")).compose(filmTime_s, kSize).panels.at(0).list;
}

std::vector<std::string> namesOf(const draw::DrawList& list) {
  std::vector<std::string> names;
  for (const draw::NamedPoint& point : list.points) names.push_back(point.name);
  return names;
}

std::map<std::string, glm::vec3> placesOf(const draw::DrawList& list) {
  std::map<std::string, glm::vec3> places;
  for (const draw::NamedPoint& point : list.points) places[point.name] = point.at_V;
  return places;
}

bool isTip(const draw::DrawList& list, glm::vec3 point_V) {
  return std::ranges::any_of(list.frustums, [&](const draw::Frustum& f) {
    return f.toRadius == 0 && glm::distance(f.to_V, point_V) < 1e-5f;
  });
}

const std::string kFree = "[body]\nprincipal_moments = [2, 3, 4]\n[motion]\nomega_body = [1, 0.5, 1.6]\n";
const std::string kTop =
    "[body]\npivot = [0, 0, 0]\n[[body.part]]\nshape = 'cylinder'\nradius = 0.3\nheight = 0.2\nmass = 2\n"
    "offset = [0, 0, 0.7]\n[motion]\nomega_body = [0.2, 0.1, 30]\n[motion.gravity]\ng = 9.81\n";

TEST(NamedPoints, AreTheTipsOfArrowsAndTheCentre) {
  const draw::DrawList list = listOf(kFree +
                                     "[show]\nspace_axes = true\n[[vector]]\ncomponents = [1, 2, 2]\n"
                                     "name = '$\\mathbf{n}_1$'\n");
  EXPECT_THAT(namesOf(list),
              UnorderedElementsAre("centre", "e1", "e2", "e3", "L", "omega", "contact", "x", "y", "z", "n1"));
  for (const auto& [name, at_V] : placesOf(list))
    EXPECT_TRUE(name == "centre" || name == "contact" || isTip(list, at_V)) << name;
  EXPECT_EQ(placesOf(list)["centre"], glm::vec3(0));
}

TEST(NamedPoints, AreTheTipsOfTheTriadAndThePartsOfL) {
  const draw::DrawList list = listOf(
      "[body]\nprincipal_moments = [2, 2, 1]\n[motion]\nomega_body = [0.5, 0, 1]\n[show]\nprincipal_axes = false\n"
      "plane = false\nellipsoid = false\ntriad = true\nL_parts = true\n");
  EXPECT_THAT(namesOf(list), IsSupersetOf({"i", "j", "k", "omega1", "omega3", "L-omega"}));
  for (const char* name : {"i", "j", "k", "omega1", "omega3", "L-omega"})
    EXPECT_TRUE(isTip(list, placesOf(list)[name])) << name;
}

// The ellipsoid touches the plane at the tip of omega, where the height 2T/L above the plane is that of the plane.
TEST(NamedPoints, HaveTheContactInThePlane) {
  const draw::DrawList list = listOf(kFree);
  const draw::GridPlane& plane = list.planes.at(0);
  auto places = placesOf(list);
  EXPECT_EQ(places["contact"], places["omega"]);
  EXPECT_NEAR(glm::dot(glm::normalize(glm::cross(plane.u_V, plane.v_V)), places["contact"] - plane.centre_V), 0,
              1e-5);
}

TEST(NamedPoints, LeaveOutWhatIsNotShown) {
  EXPECT_THAT(
      namesOf(listOf(kFree + "[show]\nL = false\nomega = false\ncontact = false\nprincipal_axes.axes = [2]\n")),
      UnorderedElementsAre("centre", "e2"));
}

// The arrow leads to the point of the body at its centre, at the scale of the body.
TEST(NamedPoints, ArePivotAndCentreOfATop) {
  auto places = placesOf(listOf(kTop + "[[vector]]\nposition_of = [0, 0, 0.7]\nname = 'to the centre'\n"));
  EXPECT_EQ(places.at("pivot"), glm::vec3(0));
  EXPECT_GT(glm::length(places.at("centre")), 0.1f);
  EXPECT_LT(glm::distance(places.at("centre"), places.at("to-the-centre")), 1e-5f);
}

TEST(NamedPoints, GrowWithTheirArrows) {
  const draw::DrawList list =
      listOf(kFree + "[[timeline]]\nat = 4\nover = 2\nshow = ['L', 'principal_axes']\n", 5);
  const auto places = placesOf(list);
  for (const char* name : {"L", "e1", "omega"}) EXPECT_TRUE(isTip(list, places.at(name))) << name;
  const auto whole = placesOf(listOf(kFree, 5));
  EXPECT_LT(glm::distance(places.at("L"), 0.5f * whole.at("L")), 1e-5f);
  EXPECT_THAT(namesOf(listOf(kFree + "[[timeline]]\nat = 4\nover = 2\nshow = ['L']\n", 3)),
              testing::Not(testing::Contains("L")));
}

TEST(NamedPoints, NameTheArrowsOfAFlight) {
  const draw::DrawList list = listOf(
      "[body]\nshape = 'box'\nsize = [0.3, 0.2, 0.1]\nmass = 1\n[motion]\nomega_body = [1, 5, 1]\n"
      "[motion.flight]\nvelocity = [1, 0, 4]\n[show]\nflight.weight = true\nflight.velocity = true\n"
      "flight.position = true\ntotal_L = true\n");
  EXPECT_THAT(namesOf(list), IsSupersetOf({"centre", "origin", "V", "weight", "orbital-L", "total-L"}));
  for (const char* name : {"V", "weight", "total-L"}) EXPECT_TRUE(isTip(list, placesOf(list).at(name))) << name;
}

TEST(PointName, KeepsLettersAndDigitsOfALabel) {
  EXPECT_EQ(pointName("$\\mathbf{v}_P$"), "vP");
  EXPECT_EQ(pointName("$\\omega_1$"), "omega1");
  EXPECT_EQ(pointName("$\\boldsymbol{\\omega}\\times\\mathbf{r}$"), "omegatimesr");
  EXPECT_EQ(pointName("the  tip - of it"), "the-tip-of-it");
  EXPECT_EQ(pointName("$\\hat{n}^\\prime$"), "nprime");
  EXPECT_EQ(pointName("50\\,\\% more"), "v50-more");
}

TEST(PointName, IsNeverEmpty) {
  for (const char* label : {"", "$$", "\xc3\xa4", "--", "\\", "$\\vec{}$"}) EXPECT_EQ(pointName(label), "vector");
}

}  // namespace
}  // namespace poinsot::stage
