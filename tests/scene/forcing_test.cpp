// SPDX-License-Identifier: Apache-2.0
// Forces and torques as scenes describe them, and the figures that they exclude from the picture.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "scene/motion/make_motion.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;
using testing::Not;

const std::string kBare = "body.principal_moments=[2, 4, 5]\nmotion.omega_body=[1, 2, 3]\n";
const std::string kTop =
    "motion.omega_body=[0, 0, 3]\n[body]\nshape='cone'\nradius=0.45\nheight=1.7\nmass=2\npivot=[0, 0, -1.275]\n";

Scene sceneWith(const std::string& text) { return parseScene(text, dataPath("test.toml")); }
std::string problems(const std::string& text) { return messagesOf(text, {}, dataPath("test.toml")); }

physics::Forcing forcingOf(const std::string& text) { return sceneWith(text).motion.forcing; }

TEST(Gravity, IsGivenByAMomentOrByMassAndPivot) {
  EXPECT_EQ(forcingOf(kBare + "[motion.gravity]\nmgr_body=[0, 0.5, 2.84375]").gravity_B,
            Vector3d(0, 0.5, 2.84375));
  // M g r = 2 kg · 9.81 m/s² · 1.275 m, by hand. Measured: exact.
  EXPECT_LE((forcingOf(kTop + "[motion.gravity]\ng=9.81").gravity_B - Vector3d(0, 0, 25.0155)).norm(), 1e-14);
}

TEST(Gravity, NeedsEitherAMomentOrAMassAndAPivot) {
  EXPECT_THAT(problems(kBare + "[motion.gravity]\ng=9.81"),
              HasSubstr("motion.gravity.g: needs a body with a mass"));
  const std::string free = "motion.omega_body=[0, 0, 3]\nbody.catalogue='racket'\n[motion.gravity]\n";
  EXPECT_THAT(problems(free + "g=9.81"), HasSubstr("motion.gravity.g: body.pivot is missing"));
  EXPECT_THAT(problems(free + "mgr_body=[0, 0, 1]"),
              HasSubstr("motion.gravity.mgr_body: this body turns about its centre of mass"));
  EXPECT_EQ(problems(kBare + "[motion.gravity]\n"),
            "motion.gravity: is empty; give mgr_body = [x, y, z], or g for a body with mass and pivot\n");
  EXPECT_EQ(problems(kTop + "[motion.gravity]\ng=9.81\nmgr_body=[0, 0, 1]"),
            "motion.gravity.g: motion.gravity.mgr_body is given too; give one of the two\n");
}

TEST(Forcing, RejectsEmptyTables) {
  const auto problemOf = [](const std::string& table) { return problems(kBare + "[motion." + table + "]\n"); };
  EXPECT_EQ(problemOf("dissipation"), "motion.dissipation: is empty; give alpha\n");
  EXPECT_EQ(problemOf("drag"), "motion.drag: is empty; give rate, one number or three\n");
  EXPECT_THAT(problemOf("torque"), HasSubstr("motion.torque: is empty; give body = [x, y, z]"));
}

TEST(Torque, MayBeConstantInBodyOrSpaceAxes) {
  const physics::Forcing forcing = forcingOf(kBare + "[motion.torque]\nbody=[1, 0, '5 mN m']\nspace=[0, -2, 0]");
  EXPECT_EQ(forcing.torque_B, Vector3d(1, 0, 0.005));
  EXPECT_EQ(forcing.torque_W, Vector3d(0, -2, 0));
}

TEST(Torque, MayChangeInSteps) {
  const physics::Forcing forcing = forcingOf(kBare +
                                             "[[motion.torque.step]]\nfrom=1\nbody=[1, 2, 3]\n"
                                             "[[motion.torque.step]]\nfrom='2 s'\nspace=[4, 5, 6]\n");
  EXPECT_EQ(forcing.torqueHistory_B.t_s, (std::vector<double>{1, 2}));
  EXPECT_EQ(forcing.torqueHistory_B.torque, (std::vector<Vector3d>{{1, 2, 3}, {0, 0, 0}}));
  EXPECT_EQ(forcing.torqueHistory_W.torque, (std::vector<Vector3d>{{0, 0, 0}, {4, 5, 6}}));
  EXPECT_FALSE(forcing.torqueHistory_B.linear);
}

TEST(Torque, RejectsStepsWithoutAscendingTimes) {
  const std::string step = "[[motion.torque.step]]\n", zero = "body=[0, 0, 0]\n";
  EXPECT_EQ(problems(kBare + step + "from=2\n" + zero + step + "from=2\n" + zero),
            "motion.torque.step[1].from: must be later than the step before, got 2 s after 2 s\n");
  EXPECT_EQ(problems(kBare + step + zero),
            "motion.torque.step[0]: from is missing: a step has a time and a torque\n");
  EXPECT_EQ(
      problems(kBare + step + "from=2\n"),
      "motion.torque.step[0]: body = [x, y, z] or space = [x, y, z] is missing: a step has a time and a torque\n");
}

// tests/scene/data/torque.csv has three lines under its header.
TEST(Torque, MayBeReadFromAFile) {
  const std::string file = kBare + "[motion.torque]\nfile='torque.csv'\n";
  const physics::Forcing body = forcingOf(file),
                         space = forcingOf(file + "file_axes='space'\ninterpolation='steps'\n");
  EXPECT_EQ(body.torqueHistory_B.t_s, (std::vector<double>{0, 1.5, 2}));
  EXPECT_EQ(body.torqueHistory_B.torque[1], Vector3d(2, 0.25, 0));
  EXPECT_TRUE(body.torqueHistory_B.linear && body.torqueHistory_W.empty());
  EXPECT_EQ(space.torqueHistory_W.t_s.size(), 3u);
  EXPECT_TRUE(!space.torqueHistory_W.linear && space.torqueHistory_B.empty());
}

TEST(Torque, ReportsAFaultyFileAtTheKeyThatNamesIt) {
  const auto found = problemsOf(kBare + "[motion.torque]\nfile='body.stl'", {}, dataPath("test.toml"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].where.line, 4);
  EXPECT_EQ(found[0].message,
            "motion.torque.file: body.stl: line 1: expected four numbers t,Nx,Ny,Nz, got \"solid tetrahedron\"");
  EXPECT_EQ(problems(kBare + "[motion.torque]\nfile='none.csv'"),
            "motion.torque.file: cannot read none.csv: No such file or directory in the scene's folder\n");
  EXPECT_EQ(
      problems(kBare + "[motion.torque]\nfile_axes='space'"),
      "motion.torque.file_axes: has no effect without motion.torque.file; give the file, or leave this key out\n");
  EXPECT_THAT(
      problems(kBare + "[motion.torque]\nfile='torque.csv'\n[[motion.torque.step]]\nfrom=1\nbody=[1, 1, 1]"),
      HasSubstr("motion.torque.step[0]: motion.torque.file is given too"));
}

const std::string kForce = "[[motion.force]]\n";

// The points are measured from the centre of mass or from the pivot. The cone's centre is its origin.
TEST(PointForce, IsReadWithItsPointAndWindow) {
  const Scene scene = sceneWith(kTop + kForce + "at=['10 cm', 0, -1]\nspace=['2 kN', 0, '1 lbf']\n" + kForce +
                                "at=[0, 0, 0]\nbody=[0, '-20 mN', 0]\nfrom='2 min'\nto=130\nname='thruster'\n");
  const auto& forces = scene.motion.forcing.forces;
  ASSERT_EQ(forces.size(), 2u);
  EXPECT_LE((forces[0].lever_B - Vector3d(0.1, 0, 0.275)).norm(), 1e-15);
  EXPECT_EQ(forces[0].force_W, Vector3d(2000, 0, 4.4482216152605));
  EXPECT_EQ(forces[0].force_B, Vector3d::Zero());
  EXPECT_TRUE(forces[0].actsAt(-1e9) && forces[0].actsAt(1e9));
  EXPECT_EQ(forces[1].lever_B, Vector3d(0, 0, 1.275));
  EXPECT_EQ(forces[1].force_B, Vector3d(0, -0.02, 0));
  EXPECT_FALSE(forces[1].actsAt(119.9));
  EXPECT_TRUE(forces[1].actsAt(120));
  EXPECT_FALSE(forces[1].actsAt(130));
  EXPECT_EQ(scene.motion.forceNames, (std::vector<std::string>{"$\\mathbf{F}_{1}$", "thruster"}));
  EXPECT_EQ(sceneWith(kBare + kForce + "at=[1, 0, 0]\nbody=[0, 1, 0]\n").motion.forceNames,
            (std::vector<std::string>{"$\\mathbf{F}$"}));
  EXPECT_TRUE(sceneWith(kBare + kForce + "at=[1, 0, 0]\nbody=[0, 1, 0]\n").motion.orientation_WB);
}

TEST(PointForce, NeedsAPointAndOneVector) {
  const std::string at = "at=[1, 0, 0]\n", body = "body=[0, 1, 0]\n", space = "space=[0, 1, 0]\n";
  EXPECT_EQ(problems(kBare + kForce + body),
            "motion.force[0]: at = [x, y, z] is missing: a force has a point and a vector\n");
  EXPECT_EQ(
      problems(kBare + kForce + at + body + kForce + at),
      "motion.force[1]: body = [x, y, z] or space = [x, y, z] is missing: a force has a point and a vector\n");
  EXPECT_EQ(problems(kBare + kForce + at + body + space),
            "motion.force[0].body: motion.force[0].space is given too; a force turns with the body or keeps its "
            "direction in space; for both, give two forces\n");
  EXPECT_EQ(problems(kBare + kForce + at + body + "from=3\nto='3 s'\n"),
            "motion.force[0].to: must be later than from, got 3 s after 3 s\n");
  EXPECT_THAT(problems(kBare + kForce + at + "body=[0, 2e30, 0]\n"), HasSubstr("motion.force[0].body: must be"));
  EXPECT_THAT(problems(kBare + kForce + at + "body=[0, '2 kg', 0]\n"), HasSubstr("a force"));
  EXPECT_THAT(problems(kBare + kForce + at + "bdy=[0, 2, 0]\n"),
              HasSubstr("motion.force[0].bdy: unknown key; did you mean motion.force[0].body?"));
}

TEST(PointForce, NeedsAMassToMoveAThrownBody) {
  const std::string force = kForce + "at=[1, 0, 0]\nbody=[0, 1, 0]\n";
  EXPECT_EQ(problems(kBare + force + "[motion.flight]\n"),
            "motion.force[0]: moves the centre of mass of a thrown body, so it needs a body with a mass; give "
            "body.mass in addition to the moments of inertia\n");
  EXPECT_EQ(problems(kBare + "body.mass=2\n" + force + "[motion.flight]\n"), "");
  EXPECT_EQ(problems(kBare + force), "");
}

TEST(PointForce, IsDoubtedIfItNeverActs) {
  const auto doubts = [](const std::string& window) {
    std::string all;
    for (const Doubt& doubt : sceneWith(kBare + "[time]\nduration=4\nspeed=0.5\nstart=1\n" + kForce +
                                        "at=[1, 0, 0]\nbody=[0, 1, 0]\n" + window)
                                  .doubts)
      all += doubt.message + "\n";
    return all;
  };
  EXPECT_EQ(doubts(""), "");
  EXPECT_EQ(doubts("from=2.5\n"), "");
  EXPECT_EQ(doubts("to=0.5\n"), "");  // acts before the film, and changes its start
  EXPECT_EQ(
      doubts("from=3.5\n"),
      "motion.force[0].from: the force begins at 3.5 s, so it never acts: the film shows the motion from 1 s "
      "to 3 s, and the start is given at 0 s\n");
  EXPECT_EQ(
      doubts("to=0\n"),
      "motion.force[0].to: the force ends at 0 s, so it never acts: the film shows the motion from 1 s to 3 s, "
      "and the start is given at 0 s\n");
}

TEST(PointForce, HidesTheConstructionAndRefusesALoop) {
  const std::string force = kForce + "at=[1, 0, 0]\nbody=[0, 1, 0]\n";
  EXPECT_FALSE(sceneWith(kBare + force).views.at(0).show.plane.visible);
  EXPECT_TRUE(sceneWith(kBare + force).views.at(0).show.figures.forces.visible);
  EXPECT_FALSE(sceneWith(kBare + force + "[show]\nforces=false\n").views.at(0).show.figures.forces.visible);
  EXPECT_THAT(problems(kBare + force + "[time]\nloop=true\n"), HasSubstr("something acts on the body"));
  EXPECT_EQ(problems(kBare + "[show.forces]\nscale=2\n"),
            "show.forces: no force acts at a point of the body: give [[motion.force]], or leave it out\n");
  EXPECT_EQ(problems("body.principal_moments=[2, 4, 5]\nmotion.omega_body=[0, 0, 0]\n" + force), "");
}

TEST(Losses, AreReadFromDragAndDissipation) {
  EXPECT_EQ(forcingOf(kBare + "[motion.drag]\nrate=0.25").dragRate_P, Vector3d(0.25, 0.25, 0.25));
  EXPECT_EQ(forcingOf(kBare + "[motion.drag]\nrate=[0, 0.5, '30 1/min']").dragRate_P, Vector3d(0, 0.5, 0.5));
  EXPECT_EQ(forcingOf(kBare + "[motion.dissipation]\nalpha=0.01").dissipation, 0.01);
}

TEST(Orientation, DefaultsToIdentityUnderGravityTorqueOrDrag) {
  const auto given = [](const char* text) { return sceneWith(kBare + text).motion.orientation_WB.has_value(); };
  EXPECT_TRUE(given("[motion.gravity]\nmgr_body=[0, 0, 1]"));
  EXPECT_TRUE(given("[motion.torque]\nbody=[0, 0, 1]"));
  EXPECT_TRUE(given("[motion.drag]\nrate=1"));
  EXPECT_FALSE(given("[motion.dissipation]\nalpha=0.01"));  // L is constant and is turned onto the vertical
  EXPECT_FALSE(given(""));
}

TEST(Flight, StartsAtTheGivenPositionAndVelocity) {
  const auto flight =
      sceneWith(kBare + "[motion.flight]\nposition=[0, 0, 1.5]\nvelocity=['36 km/h', 0, 4]\n").motion.flight;
  ASSERT_TRUE(flight);
  EXPECT_EQ(flight->position_W, Vector3d(0, 0, 1.5));
  EXPECT_LE((flight->velocity_W - Vector3d(10, 0, 4)).norm(), 1e-14);
  EXPECT_EQ(flight->gravity_W, Vector3d(0, 0, -9.80665));
  EXPECT_TRUE(sceneWith(kBare + "[motion.flight]\n").motion.flight);
  // Poinsot's construction is shown only on request.
  const auto shown = [](const std::string& more) {
    const Show show = sceneWith(kBare + "[motion.flight]\n" + more).views.at(0).show;
    return std::vector{show.ellipsoid.visible, show.plane.visible, show.height.visible, show.L.visible};
  };
  EXPECT_EQ(shown(""), (std::vector{false, false, false, true}));
  EXPECT_EQ(shown("[show]\nellipsoid = true\nplane.grid = false\n"), (std::vector{true, true, false, true}));
  EXPECT_EQ(shown("[[timeline]]\nat = 1\nshow = [\"plane\"]\n"), (std::vector{false, true, false, true}));
  EXPECT_EQ(shown("[show]\nflight = false\n"), (std::vector{true, true, true, true}));
  EXPECT_FALSE(sceneWith(kBare).motion.flight);
  EXPECT_EQ(problems(kTop + "[motion.flight]\n"),
            "motion.flight: a thrown body turns about its centre of mass, but body.pivot holds it at a fixed "
            "point; leave out one of the two\n");
}

TEST(Flight, FiguresOfAFlightNeedAThrownBody) {
  const std::string thrown = "[motion.flight]\nvelocity=[1, 0, 2]\n";
  EXPECT_EQ(problems(kBare + "[show]\nflight=false\n"), "");
  EXPECT_EQ(problems(kBare + "[show.flight]\nweight=true\n"),
            "show.flight: nothing is thrown: give [motion.flight], or leave it out\n");
  EXPECT_THAT(problems(kTop + "[motion.gravity]\ng=9.81\n[show.flight]\nweight=true\n"),
              HasSubstr("[[vector]] with components = [0, 0, -1]"));
  EXPECT_EQ(problems(kBare + "[camera]\nfollow=true\n"),
            "camera.follow: nothing is thrown: give [motion.flight], or leave it out\n");
  EXPECT_EQ(problems(kBare + "[[view]]\n[[view]]\ncamera.follow=true\n"),
            "view[1].camera.follow: nothing is thrown: give [motion.flight], or leave it out\n");
  EXPECT_EQ(problems(kBare + "[camera]\nfollow=false\n"), "");
  EXPECT_EQ(problems(kBare + "[show]\ntotal_L=true\n"),
            "show.total_L: exists only for a thrown body: give [motion.flight], or leave it out\n");
  EXPECT_EQ(
      problems(kBare + thrown + "[[view]]\nshow.total_L=true\n"),
      "view[0].show.total_L: needs a body with a mass; give body.mass in addition to the moments of inertia\n");
}

TEST(Flight, QuantitiesOfAFlightNeedAThrownBody) {
  const std::string thrown = "[motion.flight]\nvelocity=[1, 0, 2]\n";
  EXPECT_EQ(problems(kBare + "[[plot]]\nquantities=['R_x', 'R_z']\n"),
            "plot[0].quantities: \"R_x\" exists only for a thrown body; give [motion.flight]\n"
            "plot[0].quantities: \"R_z\" exists only for a thrown body; give [motion.flight]\n");
  EXPECT_EQ(problems(kBare + thrown + "[[plot]]\nquantities=['R_x', 'R_z']\n"), "");
  EXPECT_THAT(problems(kBare + thrown + "[[readout]]\nquantity='T_cm'\n"),
              HasSubstr("readout[0].quantity: \"T_cm\" needs a body with a mass"));
  EXPECT_EQ(problems(kBare + thrown + "[[plot]]\nquantities=['L_K_rotation_x']\n"),
            "plot[0].quantities: \"L_K_rotation_x\" exists only for a body that is thrown by a point; give "
            "motion.flight.point\n");
}

TEST(Flight, AProblemOfTheBodyIsNotReportedAgainAtAQuantity) {
  EXPECT_THAT(
      problems("[body]\nshape='box'\nsize=[1, 2, 3]\nmass=1\n[motion]\nomega_body=[1, 2, 3]\n[motion.flight]\n"
               "velocity=[1, 0, 2]\npoint='x'\n[[plot]]\nquantities=['L_K_rotation_x']\n"),
      Not(HasSubstr("plot[0]")));
  EXPECT_EQ(
      problems("[body]\nshape='box'\nsize=[1, 2, 3]\nmass=-1\n[motion]\nomega_body=[1, 2, 3]\n[motion.flight]\n"
               "velocity=[1, 0, 2]\n[[plot]]\nquantities=['P_x']\n"),
      "body.mass: must be positive, from 1e-60 to 1e+60 kg, got -1 kg\n");
}

// A picture whose camera goes with the body may repeat.
TEST(Flight, LoopIsRejectedIfThePictureShowsTheFlight) {
  const std::string thrown = "[motion.flight]\nvelocity=[1, 0, 2]\n[time]\nloop=true\n";
  EXPECT_THAT(problems(kBare + thrown), HasSubstr("time.loop: a thrown body does not return"));
  EXPECT_EQ(problems(kBare + thrown + "[show]\nflight=false\n"), "");
  EXPECT_EQ(problems(kBare + thrown + "[camera]\nframe='body'\n"), "");
}

TEST(PoinsotConstruction, IsShownByDefaultOnlyIfLIsConstant) {
  const Show free = sceneWith(kBare).show, lossy = sceneWith(kBare + "[motion.dissipation]\nalpha=0.01").show;
  const Show dragged = sceneWith(kBare + "[motion.drag]\nrate=0.1").show;
  for (const Show& show : {free, lossy})
    EXPECT_TRUE(show.plane.visible && show.polhode.visible && show.height.visible);
  EXPECT_FALSE(dragged.plane.visible || dragged.ellipsoid.visible || dragged.contact.visible ||
               dragged.polhode.visible || dragged.herpolhode.visible || dragged.height.visible);
  EXPECT_TRUE(dragged.L.visible && dragged.omega.visible && dragged.body.visible);
}

TEST(PoinsotConstruction, IsRejectedIfLIsNotConstant) {
  EXPECT_EQ(
      problems(kBare + "[motion.drag]\nrate=0.1\n[show]\nplane=true"),
      "show.plane.visible: under gravity, torque or drag L is not constant, so Poinsot's construction does not "
      "exist; leave it out\n");
  EXPECT_EQ(problems(kBare + "[motion.drag]\nrate=0.1\n[show]\nplane=false"), "");
  EXPECT_THAT(problems(kBare + "[motion.drag]\nrate=0.1\n[show]\nexaggerate_angles=10"),
              HasSubstr("show.exaggerate_angles: exaggerated angles belong to another motion"));
}

TEST(BodyAtRest, IsAcceptedIfATorqueStartsIt) {
  const std::string rest = "body.principal_moments=[2, 4, 5]\nmotion.omega_body=[0, 0, 0]\n";
  EXPECT_EQ(problems(rest + "[motion.gravity]\nmgr_body=[1, 0, 1]"), "");
  EXPECT_EQ(problems(rest + "[[motion.torque.step]]\nfrom=1\nspace=[1, 0, 0]"), "");
  EXPECT_THAT(problems(rest + "[motion.drag]\nrate=1"), HasSubstr("motion.omega_body: must not be zero"));
}

/// Returns the angle between the body's z axis and the world's, in degrees.
double tilt_deg(const physics::RigidBodyState& state) {
  const Vector3d axis_W = state.q_WB * Vector3d::UnitZ();
  return std::atan2(axis_W.cross(Vector3d::UnitZ()).norm(), axis_W.z()) * 180 / std::numbers::pi;
}

// This heavy top, released at 30 degrees, nutates by its closed form to 38.840183490757 degrees and back in
// 1.83064120697989845 s. Measured: 4e-13 and 4e-15 degrees.
TEST(MakeMotion, MakesAHeavyTopNutate) {
  const Scene scene = sceneWith(
      "body.principal_moments=[1.40625, 1.40625, 0.65625]\n[motion]\nomega_body=[0, 0, 9.15625]\n"
      "orientation=[0.9659258262890683, 0.25881904510252074, 0, 0]\n[motion.gravity]\nmgr_body=[0, 0, 2.84375]\n");
  const double period = 1.83064120697989845;
  const auto motion = makeMotion(scene, 0, 2);
  EXPECT_NEAR(tilt_deg(motion->at(0)), 30, 1e-12);
  EXPECT_NEAR(tilt_deg(motion->at(period / 2)), 38.840183490757, 1e-11);
  EXPECT_NEAR(tilt_deg(motion->at(period)), 30, 1e-11);
}

TEST(MakeMotion, AcceptsASpanInEitherOrder) {
  const Scene scene = sceneWith(kBare + "[motion.torque]\nbody=[0, 0, 1]\n");
  const auto forward = makeMotion(scene, -1, 2), backward = makeMotion(scene, 2, -1);
  for (const double t_s : {-1.0, 0.5, 2.0}) EXPECT_EQ(forward->at(t_s).L_W, backward->at(t_s).L_W);
}

}  // namespace
}  // namespace poinsot::scene
