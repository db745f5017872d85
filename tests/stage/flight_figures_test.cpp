// SPDX-License-Identifier: Apache-2.0
// Thrown bodies: the parabola and the momenta. Expected values are by hand, from the closed form of uniform
// acceleration and from the sums over five masses in PHYSICS (eq 1 to 10).
#include "stage/figures/flight_figures.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "scene_samples.h"
#include "scenery.h"
#include "stage/figures/ghosts_figure.h"
#include "stage/figures/named_figures.h"
#include "stage/figures/trace_figure.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr glm::ivec2 kSize{960, 540};
constexpr double kTimes_s[] = {0, 0.4, 1.3, 1.9};
const Vector3d kStart(0.34375, 0.09375, 0.0234375), kVelocity(1.2, -0.7, 0.4), kGravity(0, 0, -9.81);

const std::string kFiveMasses = R"(
[motion]
omega_body = [0.6, -1.1, 0.8]
orientation = [1, 0, 0, 0]
[motion.flight]
position = [0.34375, 0.09375, 0.0234375]
velocity = [1.2, -0.7, 0.4]
gravity = [0, 0, -9.81]
[time]
duration = 2
speed = 1
[[body.point_mass]]
mass = 1.5
position = [0.5, -1.25, 0.75]
[[body.point_mass]]
mass = 0.75
position = [-1, 0.25, 1.5]
[[body.point_mass]]
mass = 2.25
position = [0.125, 0.875, -0.625]
[[body.point_mass]]
mass = 1.125
position = [1.75, 0.5, -0.25]
[[body.point_mass]]
mass = 0.375
position = [-0.5, -0.75, -1.125]
)";
const std::string kBare =
    "[show]\nellipsoid = false\nplane = false\nherpolhode = false\npolhode = false\ncontact = false\n"
    "principal_axes = false\nL = false\nomega = false\nlabels = false\n";

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  return text.replace(text.find(from), from.size(), to);
}

Vector3d centre_W(double t_s) { return kStart + t_s * kVelocity + 0.5 * t_s * t_s * kGravity; }

TEST(FlightFigure, ThePathIsTheParabolaOfTheCentreOfMass) {
  for (const double scale : {1.0, 0.3}) {
    const Scenery s(kFiveMasses + kBare + "flight.scale = " + std::to_string(scale));
    const FlightFigure figure(s.setting);
    EXPECT_EQ(s.scales.flight, scale * s.scales.body);
    for (const double now_s : kTimes_s) {
      const PictureState state = s.motion.at(now_s);
      const std::vector<Vector3d> path = figure.path_V(state, 0, 2);
      ASSERT_GT(path.size(), 90u);
      for (const Vector3d& p_V : path) {
        const Vector3d p_W = p_V / s.scales.flight + centre_W(now_s);
        const double t_s = (p_W.x() - kStart.x()) / kVelocity.x();
        ASSERT_LT((p_W - centre_W(t_s)).norm(), 1e-13);  // measured 2e-14
      }
      EXPECT_LT((path.front() - s.scales.flight * (centre_W(0) - centre_W(now_s))).norm(), 1e-14);
      EXPECT_LT((path.back() - s.scales.flight * (centre_W(2) - centre_W(now_s))).norm(), 1e-14);
    }
  }
}

// A long fall would show the body as a speck: 10 m/s^2 for 12 s are 700 m.
TEST(FlightFigure, ALongPathIsScaledDownToKeepTheBodyVisible) {
  const auto shareOfBody = [](const std::string& duration, const std::string& lines = "") {
    std::string text = kFiveMasses + kBare + lines;
    text.replace(text.find("duration = 2"), 12, "duration = " + duration);
    const Scenery s(text);
    Eigen::AlignedBox3d path;
    for (const PathPoint& p : s.motion.outline())
      path.extend(s.scales.flight * s.motion.atPlayed(p.played_s).centre_V);
    return std::pair(s.scales.flight / s.scales.body, s.scales.reach / path.diagonal().norm());
  };
  EXPECT_EQ(shareOfBody("1").first, 1);
  const auto [scale, share] = shareOfBody("12");
  EXPECT_LT(scale, 0.1);
  EXPECT_NEAR(share, 1.0 / 9, 1e-12);
  EXPECT_EQ(shareOfBody("12", "flight.scale = 1\n").first, 1);
}

TEST(FlightFigure, ArrowsShowPositionVelocityAndWeight) {
  const Scenery s(kFiveMasses + kBare);
  const FlightFigure figure(s.setting);
  for (const double t : kTimes_s) {
    const PictureState state = s.motion.at(t);
    EXPECT_LT((figure.origin_V(state) + s.scales.flight * centre_W(t)).norm(), 1e-14);
    EXPECT_LT((figure.velocityTip_V(state) - s.scales.velocity * (kVelocity + t * kGravity)).norm(), 1e-14);
    EXPECT_LT(figure.weightTip_V(state).normalized().cross(-Vector3d::UnitZ()).norm(), 1e-15);
    EXPECT_LT(figure.weightTip_V(state).z(), 0);
  }
}

// The point K is the first mass, 1.5 kg. R and V of the scene are then those of K, and r is measured from it (eq
// 4).
TEST(FlightFigure, ArrowsShowPositionAndVelocityOfThePointThatIsThrown) {
  const Scenery s(replaced(kFiveMasses, "gravity", "point = [0.5, -1.25, 0.75]\ngravity") + kBare +
                  "flight.scale = 1\n[[vector]]\nposition_of = [1.75, 0.5, -0.25]\n");
  const FlightFigure figure(s.setting);
  const PictureState start = s.motion.at(0);
  const Vector3d K = figure.point_V(start);
  EXPECT_LT((K - figure.origin_V(start) - s.scales.flight * kStart).norm(), 1e-14);
  EXPECT_LT((figure.velocityTip_V(start) - K - s.scales.velocity * kVelocity).norm(), 1e-14);
  const NamedVectorFigure r(s.setting, s.scene.vectors.at(0));
  for (const double t : kTimes_s) {
    const PictureState state = s.motion.at(t);
    const NamedVectorFigure::Arrow arrow = r.arrow(state);
    EXPECT_LT((arrow.from_V - figure.point_V(state)).norm(), 1e-15);
    EXPECT_LT((arrow.tip_V - arrow.from_V - s.scales.body * (state.R_VB * Vector3d(1.25, 1.75, -1))).norm(),
              1e-14);
  }
}

// The sides of the arrow V + omega x r are V of K and omega x r from K (eq 4).
TEST(NamedVector, VelocityHasTheSidesOfThePointThatIsThrown) {
  const Scenery s(replaced(kFiveMasses, "gravity", "point = [0.5, -1.25, 0.75]\ngravity") + kBare +
                  "[[vector]]\nvelocity_of = [1.75, 0.5, -0.25]\n");
  const NamedVectorFigure::Arrow arrow = NamedVectorFigure(s.setting, s.scene.vectors.at(0)).arrow(s.motion.at(0));
  ASSERT_TRUE(arrow.corner_V);
  EXPECT_LT(((*arrow.corner_V - arrow.from_V) / s.scales.velocity - kVelocity).norm(), 1e-14);
  const Vector3d turning = Vector3d(0.6, -1.1, 0.8).cross(Vector3d(1.25, 1.75, -1));
  EXPECT_LT(((arrow.tip_V - *arrow.corner_V) / s.scales.velocity - turning).norm(), 1e-14);
}

// K is fast, and the centre of mass is not. V of K fits the picture as V of a fast centre does.
TEST(FlightFigure, AFastPointThatIsThrownHasAnArrowOfUsualLength) {
  const std::string fast = replaced(replaced(kFiveMasses, "[0.6, -1.1, 0.8]", "[6, -11, 8]"),
                                    "gravity = [0, 0, -9.81]", "point = [0.5, -1.25, 0.75]\ngravity = [0, 0, 0]");
  const Scenery s(fast + kBare);
  const FlightFigure figure(s.setting);
  for (const double t : kTimes_s) {
    const PictureState state = s.motion.at(t);
    EXPECT_LT((figure.velocityTip_V(state) - figure.point_V(state)).norm(), 1) << t;
  }
}

// The eye's place in space does not depend on the time; the body, at V's origin, goes along the parabola.
TEST(FlightFigure, TheCameraIsFixedInSpace) {
  const std::string text = kFiveMasses + kBare;
  const Scenery s(text);
  const Stage stage(scene::parseScene(text, "sample.toml"));
  const auto eye_W = [&](double t) {
    return Vector3d(fromPicture(onlyList(stage, t, kSize).camera.eye_V) + s.scales.flight * centre_W(t));
  };
  for (const double t : kTimes_s) EXPECT_LT((eye_W(t) - eye_W(0)).norm(), 3e-6) << t;  // floats; measured 6e-7
}

TEST(FlightFigure, TheFollowingCameraKeepsTheBodyInPlace) {
  const std::string text = kFiveMasses + "[camera]\nfollow = true\n";
  const Scenery s(text);
  const Stage stage(scene::parseScene(text, "sample.toml"));
  const Stage still(scene::parseScene(kFiveMasses, "sample.toml"));
  const auto at_px = [&](double t) { return project(onlyList(stage, t, kSize).camera, glm::vec3(0)); };
  for (const double t : kTimes_s) {
    EXPECT_LT(glm::distance(at_px(t), at_px(0)), 1e-4f) << t;
    const draw::Camera camera = onlyList(stage, t, kSize).camera;
    for (const double other : kTimes_s) {
      const Vector3d place_V = s.scales.flight * (centre_W(other) - centre_W(t));
      EXPECT_LT(depthOf(camera, toPicture(place_V)), camera.far);
    }
  }
  const auto unit_px = [](const Stage& of) {
    const draw::Camera camera = onlyList(of, 0, kSize).camera;
    return camera.scale_px(depthOf(camera, glm::vec3(0)));
  };
  EXPECT_GT(unit_px(stage), 1.5f * unit_px(still));  // as near as the body allows; measured 2.4
}

TEST(FlightFigure, KeepsTheScaleIfTheCameraFollows) {
  const auto shrinks = [&](const std::string& more) {
    const Scenery s(replaced(kFiveMasses + kBare + more, "duration = 2", "duration = 12"));
    return s.scales.flight < s.scales.body;
  };
  EXPECT_TRUE(shrinks(""));
  EXPECT_FALSE(shrinks("[camera]\nfollow = true\n"));
}

// The origin is 170 m behind the body, at its height. An eye in front of the body sees the origin. For an eye
// behind the body, the origin is behind the eye and has no label.
TEST(FlightFigure, LabelsTheOriginOnlyInFrontOfTheCamera) {
  for (const int azimuth_deg : {0, 90, 180, 270}) {
    const std::string follow =
        fmt::format("[camera]\nfollow = true\nelevation = 0\nazimuth = \"{} deg\"\n", azimuth_deg);
    const Stage stage(scene::parseScene(replaced(kFiveMasses, "[1.2, -0.7, 0.4]", "[90, 0, 9.3]") + follow, ""));
    const auto names = onlyList(stage, 1.9, kSize).texts;
    EXPECT_EQ(std::ranges::any_of(names, [](const draw::Text& t) { return t.tex == "$O$"; }), azimuth_deg == 0)
        << azimuth_deg;
  }
}

TEST(FlightFigure, IsDrawnOnlyInTheSpaceFrame) {
  for (const char* frame : {"body", "space"}) {
    const bool still = std::string(frame) == "space";
    const Scenery s(kFiveMasses + kBare + "[camera]\nframe = \"" + frame + "\"\n");
    EXPECT_EQ(s.motion.flight().has_value(), still);
    if (!still) {
      EXPECT_TRUE(s.motion.at(1.3).centre_V.isZero(0) && s.motion.at(1.3).velocity_V.isZero(0));
    }
  }
  EXPECT_FALSE(Scenery(kFiveMasses + kBare + "flight = false\n").motion.flight());
}

// Eq (5) and (8) with the numbers of the five masses: at the start, and half a second later, when the weight's
// torque has changed R x P, and L is still the same.
TEST(TotalAngularMomentum, IsTheSumOfItsPartsAndChangesByTheWeightsTorque) {
  const Scenery s(kFiveMasses + kBare + "total_L = true\n");
  const TotalAngularMomentumFigure figure(s.setting);
  const Vector3d orbital(0.3234375, -0.65625, -2.11875), L(6.0150146484375, -7.01356201171875, 5.062939453125);
  const Vector3d gained(2.3911875, 18.9455625, 0);
  const PictureState start = s.motion.at(0), later = s.motion.at(0.5);
  const auto inSI = [&](const Vector3d& v_V) { return Vector3d(v_V / s.scales.L); };
  EXPECT_LT((inSI(figure.orbital_V(start)) - orbital).norm(), 1e-14);    // measured 5e-16
  EXPECT_LT((inSI(figure.total_V(start)) - orbital - L).norm(), 2e-14);  // measured 2e-15
  EXPECT_LT((inSI(figure.orbital_V(later)) - orbital - gained).norm(), 3e-14);
  EXPECT_LT((inSI(figure.total_V(later)) - orbital - L - gained).norm(), 3e-14);
  const Vector3d torque = figure.torque_V(later), expected = centre_W(0.5).cross(6 * kGravity);
  EXPECT_LT(torque.normalized().cross(expected.normalized()).norm(), 1e-15);
  EXPECT_GT(torque.dot(expected), 0);
}

// V + omega x r (eq 4) is the rate of change of the point's place: a difference of places over 2e-5 s.
TEST(NamedVector, VelocityOfAThrownBodyIsRelativeToSpace) {
  const Scenery s(kFiveMasses + kBare + "[[vector]]\nvelocity_of = [0.5, -1.25, 0.75]\n");
  const NamedVectorFigure figure(s.setting, s.scene.vectors.at(0));
  const auto place_W = [&](double t) {
    const PictureState state = s.motion.at(t);
    return Vector3d(centre_W(t) + figure.arrow(state).from_V / s.scales.body);
  };
  for (const double t : {0.4, 1.3, 1.9}) {
    const NamedVectorFigure::Arrow arrow = figure.arrow(s.motion.at(t));
    const Vector3d drawn = (arrow.tip_V - arrow.from_V) / s.scales.velocity;
    EXPECT_LT((drawn - (place_W(t + 1e-5) - place_W(t - 1e-5)) / 2e-5).norm(), 1e-9) << t;  // measured 2e-10
    ASSERT_TRUE(arrow.corner_V);
    EXPECT_LT(((*arrow.corner_V - arrow.from_V) / s.scales.velocity - kVelocity - t * kGravity).norm(), 1e-13);
  }
}

TEST(GhostsFigure, HasThePosesOfAThrownBody) {
  const Scenery s(kFiveMasses + kBare + "[show.ghosts]\nvisible = true\ntimes = [0.2, 1.2]\n");
  const GhostsFigure figure(s.setting);
  const double wanted[] = {0.2, 1.2};
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((figure.poses().at(i).place_V - s.scales.flight * centre_W(wanted[i])).norm(), 1e-14);
    EXPECT_LT((figure.poses().at(i).R_WB - s.motion.at(wanted[i]).R_VB).norm(), 1e-15);
  }
}

// Each pose that the body has reached adds as many balls as the body has; one more ball is the centre. Later poses
// add none.
TEST(GhostsFigure, AppearOnlyAfterAThrownBodyWasThere) {
  const Stage stage(scene::parseScene(
      kFiveMasses + kBare + "flight.position = false\n[show.ghosts]\nvisible = true\ntimes = [0.2, 1.2]\n",
      "sample.toml"));
  const auto balls = [&](double t) { return onlyList(stage, t, kSize).ellipsoids.size(); };
  const std::size_t body = balls(0.1) - 1;
  EXPECT_GE(body, 5u);
  EXPECT_EQ(balls(0.5) - 1, 2 * body);
  EXPECT_EQ(balls(1.5) - 1, 3 * body);
}

// The end of a hammer's handle is traced: it is 0.1 m of head and 0.8 m of handle away from the head's middle.
TEST(TraceFigure, TracesTheFarEndOfAThrownHammer) {
  const auto traced = [](const std::string& side) {
    const Scenery s(
        "[motion]\nomega_body = [0, 8, 0]\n[motion.flight]\nvelocity = [3, 0, 4]\n"
        "[[body.part]]\nshape = 'cube'\nedge = 0.2\nmass = 2\n"
        "[[body.part]]\nshape = 'cylinder'\nradius = 0.02\nheight = 0.8\nmass = 0.5\noffset = [0, 0, " +
        side + "0.5]\n");
    const Vector3d end_B = TraceFigure(s.setting).point_V(s.motion.at(0)) / s.scales.body;
    return Vector3d(s.motion.at(0).R_VB.transpose() * end_B);
  };
  const double centre = 0.5 * 0.5 / 2.5;  // centre of mass, from the head's middle
  EXPECT_LT((traced("") - Vector3d(0, 0, 0.9 - centre)).norm(), 1e-14);
  EXPECT_LT((traced("-") + Vector3d(0, 0, 0.9 - centre)).norm(), 1e-14);
}

TEST(TraceFigure, FollowsThePathOfAThrownBodyInSpace) {
  const std::string text =
      kFiveMasses + kBare + "flight.visible = false\n[show.trace]\nvisible = true\npoint = [0.5, -1.25, 0.75]\n";
  const std::string flying =
      kFiveMasses + kBare +
      "body = false\nflight.position = false\nflight.velocity = false\n[show.trace]\nvisible = true\n"
      "point = [0.5, -1.25, 0.75]\n";
  const Scenery s(flying);
  const TraceFigure figure(s.setting);
  const auto list = onlyList(Stage(scene::parseScene(flying, "sample.toml")), 1.3, kSize);
  EXPECT_TRUE(list.glassEllipsoids.empty());
  ASSERT_EQ(list.curves.size(), 5u);  // past, last second, future; two of the centre of mass
  // The path ends where the point was at the start, and where it will be.
  const auto relative = [&](double t) {
    const Vector3d r_V = figure.point_V(s.motion.at(t));
    return toPicture(Vector3d(s.scales.flight * (centre_W(t) - centre_W(1.3)) + r_V));
  };
  const auto isEnd = [&](const glm::vec3& p) {
    return std::ranges::any_of(list.curves, [&](const draw::Curve& c) {
      return glm::distance(c.points_V.front(), p) < 1e-6f || glm::distance(c.points_V.back(), p) < 1e-6f;
    });
  };
  EXPECT_TRUE(isEnd(relative(0)) && isEnd(relative(1.3)) && isEnd(relative(2)));
  EXPECT_FALSE(Scenery(text).motion.flight());
}

}  // namespace
}  // namespace poinsot::stage
