// SPDX-License-Identifier: Apache-2.0
// Bodies given by measured moments and a mass. Expected values are sums over point masses, whose numbers are exact
// in binary, and solids of the same mass and moments.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using testing::HasSubstr;

struct Mass {
  double mass_kg;
  Vector3d at_B;
};

struct Particles {
  std::vector<Mass> masses;
  double mass_kg = 0;
  Vector3d centre_B = Vector3d::Zero();

  explicit Particles(std::vector<Mass> all) : masses(std::move(all)) {
    for (const Mass& m : masses) mass_kg += m.mass_kg;
    for (const Mass& m : masses) centre_B += m.mass_kg / mass_kg * m.at_B;
  }

  Matrix3d inertiaAbout(const Vector3d& point_B) const {
    Matrix3d sum = Matrix3d::Zero();
    for (const Mass& m : masses) {
      const Vector3d r = m.at_B - point_B;
      sum += m.mass_kg * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
    }
    return sum;
  }

  Vector3d weightAbout(const Vector3d& point_B, double g) const {
    Vector3d sum = Vector3d::Zero();
    for (const Mass& m : masses) sum += m.mass_kg * g * (m.at_B - point_B);
    return sum;
  }
};

std::string row(const Vector3d& v) { return fmt::format("[{}, {}, {}]", v[0], v[1], v[2]); }

std::string rows(const Matrix3d& m) {
  return fmt::format("[{}, {}, {}]", row(m.row(0)), row(m.row(1)), row(m.row(2)));
}

/// Choice of the keys that describe a body of 8 kg, whose centre is off the origin and whose pivot is off both.
struct Choice {
  bool tensor, mass, centre, pivot, flight;
  int about;    // 0: not given; 1: centre_of_mass; 2: origin; 3: pivot
  int gravity;  // 0: none; 1: g; 2: mgr_body along the lever; 3: across it
};

class Combination {
 public:
  explicit Combination(const Choice& choice) : choice_(choice), body_(massesOf(choice)) {}

  Vector3d pivot_B() const { return choice_.tensor ? Vector3d(-0.5, 0.25, -1) : Vector3d(0, 0, -1.5); }
  Vector3d fixed_B() const { return choice_.pivot ? pivot_B() : body_.centre_B; }
  const Particles& body() const { return body_; }

  std::string text() const {
    std::string scene = "[body]\n";
    const Matrix3d I = body_.inertiaAbout(about_B());
    scene += choice_.tensor ? "inertia = " + rows(I) : "principal_moments = " + row(I.diagonal());
    if (choice_.mass) scene += fmt::format("\nmass = {}", body_.mass_kg);
    if (choice_.centre) scene += "\ncentre_of_mass = " + row(body_.centre_B);
    if (choice_.pivot) scene += "\npivot = " + row(pivot_B());
    constexpr const char* kAbout[] = {"", "centre_of_mass", "origin", "pivot"};
    if (choice_.about > 0) scene += fmt::format("\nmoments_about = \"{}\"", kAbout[choice_.about]);
    scene += "\n[motion]\nomega_body = [0.5, 0.25, 3]\n";
    if (choice_.gravity == 1) scene += "gravity.g = 8\n";
    if (choice_.gravity > 1) scene += "gravity.mgr_body = " + row(mgr_B()) + "\n";
    return scene + (choice_.flight ? "[motion.flight]\n" : "");
  }

  /// Returns the keys that are wrong by the rules of docs/scene.md.
  std::set<std::string> wrong() const {
    std::set<std::string> keys;
    if (!choice_.mass) {
      if (choice_.pivot) keys.insert("body.pivot");
      if (choice_.centre) keys.insert("body.centre_of_mass");
      if (choice_.about > 0) keys.insert("body.moments_about");
    } else if (choice_.about == 3 && !choice_.pivot) {
      keys.insert("body.moments_about");
    }
    const bool known = keys.empty();  // gravity is checked only for a valid body
    if (known && choice_.gravity == 1 && !(choice_.mass && choice_.pivot)) keys.insert("motion.gravity.g");
    if (known && choice_.gravity > 1 && choice_.mass && (!choice_.pivot || choice_.gravity == 3))
      keys.insert("motion.gravity.mgr_body");
    if (choice_.flight && (choice_.pivot || choice_.gravity > 0)) keys.insert("motion.flight");
    return keys;
  }

  Vector3d gravity_B() const {
    if (choice_.gravity == 1) return body_.weightAbout(pivot_B(), 8);
    return choice_.gravity == 0 ? Vector3d(Vector3d::Zero()) : mgr_B();
  }

 private:
  static std::vector<Mass> massesOf(const Choice& choice) {
    const Vector3d centre = !choice.centre  ? Vector3d(0, 0, 0)
                            : choice.tensor ? Vector3d(1, 0.5, -0.25)
                                            : Vector3d(0, 0, 0.75);
    std::vector<Mass> masses;
    for (const double side : {-1.0, 1.0}) {
      masses.push_back({1, centre + side * Vector3d(0.75, choice.tensor ? 0.5 : 0, 0)});
      masses.push_back({1, centre + side * Vector3d(0, 1.25, choice.tensor ? -0.25 : 0)});
      masses.push_back({2, centre + side * Vector3d(0, 0, 0.5)});
    }
    return masses;
  }

  Vector3d about_B() const {
    if (choice_.about == 2) return Vector3d::Zero();
    return choice_.about == 3 ? pivot_B() : body_.centre_B;
  }

  Vector3d mgr_B() const {
    const Vector3d along = body_.weightAbout(pivot_B(), 4);
    return choice_.gravity == 2 ? along : Vector3d(along[2], along[0], along[1] + 1);
  }

  Choice choice_;
  Particles body_;
};

std::vector<Choice> allChoices() {
  std::vector<Choice> all;
  for (int bits = 0; bits < 32; ++bits)
    for (int about = 0; about < 4; ++about)
      for (int gravity = 0; gravity < 4; ++gravity)
        all.push_back({(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0, (bits & 16) != 0, about,
                       gravity});
  return all;
}

std::set<std::string> keysOf(const std::vector<Problem>& problems) {
  std::set<std::string> keys;
  for (const Problem& problem : problems) keys.insert(problem.message.substr(0, problem.message.find(':')));
  return keys;
}

void expectBody(const Scene& scene, const Combination& combination, bool mass) {
  const Particles& body = combination.body();
  ASSERT_EQ(scene.body.mass.has_value(), mass);
  EXPECT_EQ(scene.motion.forcing.gravity_B, combination.gravity_B());
  if (!mass) return;
  const Vector3d fixed_B = combination.fixed_B();
  const Matrix3d expected = body.inertiaAbout(fixed_B);
  EXPECT_EQ(scene.body.mass->mass_kg(), body.mass_kg);
  EXPECT_EQ(scene.body.mass->centre_B(), body.centre_B);
  EXPECT_EQ(scene.body.mass->inertia_B(), body.inertiaAbout(body.centre_B));
  EXPECT_EQ(scene.body.fixedPoint_B(), fixed_B);
  EXPECT_LE((scene.body.axes.inertia_B() - expected).norm(), 1e-15 * expected.norm());  // measured 1e-16
}

// 512 scenes combine two forms of the moments, with and without mass, centre, pivot and flight, four points that
// the moments are about, and four kinds of gravity. Each must have the right numbers, or report its contradiction.
TEST(MeasuredBody, MatchesItsParticlesOrReportsAContradiction) {
  int good = 0;
  for (const Choice& choice : allChoices()) {
    const Combination combination(choice);
    SCOPED_TRACE(combination.text());
    const auto problems = problemsOf(combination.text());
    ASSERT_EQ(keysOf(problems), combination.wrong());
    if (!problems.empty()) continue;
    ++good;
    expectBody(parseScene(combination.text(), "test.toml"), combination, choice.mass);
  }
  // With a mass, 4 bodies: without a pivot 3 points by 2 (flight), with a pivot 4 points by 3 (gravity). Without a
  // mass, 2 by 4.
  EXPECT_EQ(good, 4 * (3 * 2 + 4 * 3) + 2 * 4);
}

const std::string kStart = "motion.omega_body = [0.1, 0.2, 1]\n";

Scene sceneOf(const std::string& text) { return parseScene(kStart + text, "test.toml"); }
std::string problems(const std::string& text) { return messagesOf(kStart + text); }

// A mass that only flies or is only printed must not change the motion, to the last bit.
TEST(MeasuredBody, MassDoesNotChangeTheMotionWithoutAPivot) {
  for (const std::string moments :
       {"principal_moments = [0.1, 0.2, 0.25]", "inertia = [[2, 0.1, 0.3], [0.1, 3, 0.7], [0.3, 0.7, 4]]"}) {
    const Scene bare = sceneOf("[body]\n" + moments), heavy = sceneOf("[body]\nmass = 7\n" + moments);
    EXPECT_EQ(bare.body.axes.moments().values(), heavy.body.axes.moments().values());
    EXPECT_EQ(bare.body.axes.q_BP().coeffs(), heavy.body.axes.q_BP().coeffs());
    EXPECT_EQ(heavy.body.fixedPoint_B(), Vector3d::Zero());
  }
}

// A cylinder of 2 kg, 0.5 m in radius and 1.5 m high, hung 1 m from its centre: I3 = M r²/2 = 0.25 kg m²,
// I1 = M (3 r² + h²)/12 = 0.5 kg m², and about the pivot 2 kg m² more; M g l = 16 N m. By hand, exact in binary.
TEST(MeasuredBody, MatchesASolidOfEqualMassAndMoments) {
  const std::string held = "mass = 2\npivot = [0, 0, -1]\n[motion.gravity]\ng = 8\n";
  const Scene solid = sceneOf("[body]\nshape = 'cylinder'\nradius = 0.5\nheight = 1.5\n" + held);
  const Scene measured = sceneOf("[body]\nprincipal_moments = [0.5, 0.5, 0.25]\n" + held);
  const Scene aboutPivot =
      sceneOf("[body]\nprincipal_moments = [2.5, 2.5, 0.25]\nmoments_about = 'pivot'\n" + held);
  for (const Scene* scene : {&measured, &aboutPivot}) {
    EXPECT_EQ(scene->body.axes.moments().values(), Vector3d(2.5, 2.5, 0.25));
    EXPECT_EQ(scene->motion.forcing.gravity_B, Vector3d(0, 0, 16));
    EXPECT_EQ(scene->body.mass->inertia_B(), Matrix3d(Vector3d(0.5, 0.5, 0.25).asDiagonal()));
  }
  EXPECT_LE((solid.body.axes.moments().values() - measured.body.axes.moments().values()).norm(), 1e-15);
  EXPECT_EQ(solid.motion.forcing.gravity_B, measured.motion.forcing.gravity_B);
}

TEST(MeasuredBody, RejectsMomentsTooSmallForMassAndPivot) {
  const std::string heavy = "[body]\nmass = 2\npivot = [0, 0, -1]\nmoments_about = 'pivot'\n";
  // About the centre of mass the moments are less by 2 kg (1 m)²: (-0.5, -0.5, 0.25) and (0.0625, 0.0625, 0.25) kg
  // m².
  EXPECT_EQ(problems(heavy + "principal_moments = [1.5, 1.5, 0.25]"),
            "body.principal_moments: the moments about body.pivot do not fit body.mass: 2 kg at 1 m from there "
            "already have M d^2 = 2 kg·m², and the remainder about the centre of mass is impossible: moments of "
            "inertia must not be negative, got principal moments (-0.5, -0.5, 0.25) kg·m²; correct the mass or "
            "the distance, or remove body.moments_about if the moments are about the centre of mass\n");
  EXPECT_THAT(problems(heavy + "inertia = [[2.0625, 0, 0], [0, 2.0625, 0], [0, 0, 0.25]]"),
              HasSubstr("body.inertia: the moments about body.pivot do not fit body.mass: 2 kg at 1 m"));
  EXPECT_THAT(problems("[body]\nmass = 2\ncentre_of_mass = [0, 0, 1]\nmoments_about = 'origin'\n"
                       "principal_moments = [1.5, 1.5, 0.25]"),
              HasSubstr("body.principal_moments: the moments about the origin do not fit body.mass"));
  // The remainder is a disc without thickness, whose axis goes through the pivot.
  EXPECT_EQ(problems(heavy + "principal_moments = [2.125, 2.125, 0.25]"), "");
}

TEST(MeasuredBody, ReportsKeysThatNeedAMass) {
  const std::string moments = "[body]\nprincipal_moments = [1, 2, 2]\n";
  for (const std::string key : {"pivot = [0, 0, 1]", "centre_of_mass = [0, 0, 1]", "moments_about = 'origin'"})
    EXPECT_EQ(problems(moments + key),
              "body." + key.substr(0, key.find(' ')) +
                  ": needs a body with a mass; give body.mass in addition to the moments of inertia (without a "
                  "mass, body.principal_moments is about the fixed point)\n");
  EXPECT_EQ(problems(moments + "mass = 1\nmoments_about = 'pivot'"),
            "body.moments_about: body.pivot is missing: it is the point about which these moments are given\n");
  EXPECT_EQ(problems(moments + "[motion.gravity]\ng = 9.81"),
            "motion.gravity.g: needs a body with a mass; give body.mass in addition to the moments of inertia, "
            "and body.pivot; or give motion.gravity.mgr_body instead\n");
  EXPECT_EQ(problems(moments + "mas = 1\npivot = [0, 0, 1]"), messagesOf(kStart + moments + "mas = 1"));
}

TEST(MeasuredBody, RejectsAWeightThatDoesNotActAtItsCentreOfMass) {
  const std::string body =
      "[body]\nprincipal_moments = [1, 1, 1]\nmass = 2\npivot = [0, 0, -0.5]\n[motion.gravity]\n";
  EXPECT_EQ(problems(body + "mgr_body = [0, 0, 9.81]"), "");
  EXPECT_EQ(problems(body + "mgr_body = [0, 0, 0]"), "");
  EXPECT_EQ(problems(body + "mgr_body = [0, 0, -9.81]"),
            "motion.gravity.mgr_body: (0, 0, -9.81) N·m contradicts body.pivot: M g r must point from the pivot "
            "to the centre of mass, along (0, 0, 0.5) m; give motion.gravity.g instead\n");
  EXPECT_EQ(problems(body + "mgr_body = [0, 0, 9.81]\ng = 9.81"),
            "motion.gravity.g: motion.gravity.mgr_body is given too; give one of the two\n");
}

TEST(MeasuredBody, AcceptsAMassButNoOtherKeyOfAShape) {
  const std::string moments = "[body]\nprincipal_moments = [1, 2, 2]\n",
                    shape = "[body]\nshape = 'cube'\nedge = 1\n";
  EXPECT_EQ(problems(moments + "density = 1000"),
            "body.density: cannot be combined with body.principal_moments, which has no volume; give body.mass "
            "instead\n");
  EXPECT_THAT(problems(moments + "mass = 1\nshape = 'cube'\nedge = 1"),
              HasSubstr("body.shape: body.principal_moments is given too"));
  EXPECT_THAT(problems(moments + "mass = 0"), HasSubstr("body.mass: must be positive"));
  EXPECT_THAT(problems(moments + "mass = -1"), HasSubstr("body.mass: must be positive"));
  EXPECT_EQ(
      problems(shape + "mass = 1\nmoments_about = 'origin'"),
      "body.moments_about: belongs to a body given by inertia or principal_moments; here body.shape sets the "
      "centre of mass and the moments; leave it out\n");
  EXPECT_THAT(problems("[body]\ncatalogue = 'racket'\ncentre_of_mass = [0, 0, 1]\n"),
              HasSubstr("body.centre_of_mass: belongs to a body given by inertia or principal_moments; here "
                        "body.catalogue sets"));
}

}  // namespace
}  // namespace poinsot::scene
