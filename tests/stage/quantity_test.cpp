// SPDX-License-Identifier: Apache-2.0
// Compares every quantity with a closed form that its code does not use.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "physics/free_motion.h"
#include "physics/precession_cones.h"
#include "scene/state_quantity.h"
#include "scene_samples.h"
#include "stage/picture_motion.h"
#include "stage/quantity_track.h"

namespace poinsot::stage {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using scene::stateQuantities;

int indexOf(std::string_view name) {
  for (std::size_t i = 0; i < stateQuantities().size(); ++i)
    if (stateQuantities()[i].name == name) return static_cast<int>(i);
  ADD_FAILURE() << "no quantity " << name;
  return 0;
}

double valueOf(std::string_view name, const physics::RigidBodyState& state, const scene::QuantityBasis& basis) {
  return scene::stateQuantity(indexOf(name)).value(state, basis);
}

// The state is made by hand: q turns by 120 degrees about (1, 1, 1), x to y to z to x.
TEST(Quantities, MatchAStateWorkedOutByHand) {
  physics::RigidBodyState s;
  s.t_s = 7;
  s.q_WB = Quaterniond(0.5, 0.5, 0.5, 0.5);
  s.omega_B = Vector3d(1, 2, 3);
  s.omega_W = Vector3d(3, 1, 2);
  s.L_W = Vector3d(12, 2, 6);  // moments 2, 3, 4
  s.kineticEnergy = 0.5 * (2 * 1 + 3 * 4 + 4 * 9);
  physics::Forcing forcing;
  forcing.gravity_B = Vector3d(5, 0, 0);  // body x points along the world's y: height 0
  const scene::QuantityBasis basis{physics::PrincipalMoments(Vector3d(2, 3, 4)), forcing, s.omega_B};
  const std::map<std::string_view, double> expected = {
      {"t", 7},
      {"omega_1", 1},
      {"omega_2", 2},
      {"omega_3", 3},
      {"omega_x", 3},
      {"omega_y", 1},
      {"omega_z", 2},
      {"L_1", 2},
      {"L_2", 6},
      {"L_3", 12},
      {"L_x", 12},
      {"L_y", 2},
      {"L_z", 6},
      {"T", 25},
      {"V", 0},
      {"E", 25},
      {"q_w", 0.5},
      {"q_x", 0.5},
      {"q_y", 0.5},
      {"q_z", 0.5},
      {"omega", std::sqrt(14.0)},
      {"L", std::sqrt(184.0)},
      {"h", 50 / std::sqrt(184.0)},
      {"rho", std::sqrt(14 - 2500.0 / 184)},
      {"theta_omega", std::acos(50 / std::sqrt(184.0 * 14))},
      // k is the third axis, which points along the world's x.
      {"theta", std::acos(12 / std::sqrt(184.0))},
      {"theta_vertical", std::numbers::pi / 2},
      // About the vertical: the line of nodes z × x is y, and the first axis (y) lies on it.
      {"phi", std::numbers::pi / 2},
      {"psi", 0},
      // The vertical and k are at right angles: the rates are omega_z and the component of omega along k.
      {"phi_rate", 2},
      {"psi_rate", 3}};
  const auto needsNothing = [](const auto& q) { return q.needs == scene::QuantityNeeds::kNothing; };
  EXPECT_EQ(static_cast<long>(expected.size()), std::ranges::count_if(stateQuantities(), needsNothing));
  for (const auto& [name, value] : expected)
    EXPECT_NEAR(valueOf(name, s, basis), value, 1e-14) << name;  // measured: at most 1.8e-15
}

// Eq (29), (32), (34): a free symmetric body has omega = L/I1 - Omega_p k.
TEST(Quantities, RatesOfEulersAnglesAreThoseOfTheLecture) {
  const physics::FreeMotion symmetric(physics::PrincipalMoments(Vector3d(2, 2, 3)), Vector3d(0.5, 0, 1),
                                      Quaterniond::Identity());
  const scene::QuantityBasis basis{physics::PrincipalMoments(Vector3d(2, 2, 3)), {}, Vector3d(0.5, 0, 1)};
  EXPECT_NEAR(valueOf("phi_rate", symmetric.at(3.7), basis), std::sqrt(1 + 9.) / 2, 1e-14);  // |(1, 0, 3)|/2
  EXPECT_NEAR(valueOf("psi_rate", symmetric.at(3.7), basis), -(3. / 2 - 1) * 1, 1e-14);
}

// Eq (29): Omega_p = (I3/I1 - 1) omega_3, with k on the side on which omega_3 is positive.
TEST(Quantities, OmegaPHasTheSignOfTheLecture) {
  const auto Omega_p = [](const Vector3d& moments, const Vector3d& omega) {
    const physics::FreeMotion motion(physics::PrincipalMoments(moments), omega, Quaterniond::Identity());
    return valueOf("Omega_p", motion.at(3.7), {physics::PrincipalMoments(moments), {}, omega});
  };
  EXPECT_NEAR(Omega_p({2, 2, 3}, {0.5, 0, 1}), 0.5, 1e-15);
  EXPECT_NEAR(Omega_p({2, 2, 3}, {0.5, 0, -1}), 0.5, 1e-15);
  EXPECT_NEAR(Omega_p({1, 2, 2}, {4, 0.5, 0}), -2, 1e-15);
  EXPECT_EQ(Omega_p({2, 2, 2}, {0.5, 0, 1}), 0);
  EXPECT_TRUE(std::isnan(Omega_p({1, 2, 3}, {0.5, 0, 1})));
}

TEST(Quantities, RatesAreTheDerivativesOfTheirAngles) {
  const Vector3d omega0(0.4, 0.3, 1.2);
  const physics::PrincipalMoments moments(Vector3d(1, 2, 2.5));
  const physics::FreeMotion motion(moments, omega0, Quaterniond::Identity());
  const scene::QuantityBasis basis{moments, {}, omega0};
  constexpr double h = 1e-3;
  for (const char* angle : {"phi", "psi"})
    for (const double t : {0.1, 1.7, 4.2}) {
      const auto turnedFrom = [&](double a, double b) {
        return std::remainder(valueOf(angle, motion.at(b), basis) - valueOf(angle, motion.at(a), basis),
                              2 * std::numbers::pi);
      };
      const double slope = (8 * turnedFrom(t - h, t + h) - turnedFrom(t - 2 * h, t + 2 * h)) / (12 * h);
      EXPECT_NEAR(valueOf(std::string(angle) + "_rate", motion.at(t), basis), slope, 1e-11)
          << angle << " " << t;  // measured 2.3e-12
    }
}

using LongVector = Eigen::Matrix<long double, 3, 1>;

/// Applies to v the shortest turn of the unit vector a onto b, by Rodrigues' formula. 1/(1 + c) is (1 - c)/n².
LongVector turnedTheShortestWay(const LongVector& a, const LongVector& b, const LongVector& v) {
  const LongVector n = a.cross(b);
  const long double c = a.dot(b), factor = c > 0 ? 1 / (1 + c) : (1 - c) / n.squaredNorm();
  return v + n.cross(v) + factor * n.cross(n.cross(v));
}

/// Returns a state with L along the pole, the third axis perpendicular to the pole, and the line of nodes at phi
/// from the meridian x of the pole.
physics::RigidBodyState stateAt(long double phi, const LongVector& pole, const LongVector& x) {
  const LongVector nodes = std::cos(phi) * x + std::sin(phi) * pole.cross(x);
  Eigen::Matrix<long double, 3, 3> R;
  R << nodes, pole, nodes.cross(pole);
  physics::RigidBodyState s;
  s.q_WB = Eigen::Quaternion<long double>(R).cast<double>();
  s.L_W = pole.cast<double>();
  return s;
}

// phi counts from the world's x turned with z onto the pole, or, within 1.4e-6 of -z, with -z onto the pole.
// Expected values are turned with 64-bit mantissas. Measured: 3.4e-16 rad.
TEST(Quantities, PhiIsExactForAnAxisNearTheDownwardVertical) {
  const scene::QuantityBasis basis{physics::PrincipalMoments(Vector3d(2, 2, 3)), {}, Vector3d::UnitZ()};
  for (const long double tilt : {0.0L, 1e-9L, 1e-7L, 1.3e-6L, 1.5e-6L, 1e-4L, 1.0L})
    for (const long double side : {0.3L, 2.9L, 4.1L}) {
      const LongVector pole(std::sin(tilt) * std::cos(side), std::sin(tilt) * std::sin(side), -std::cos(tilt));
      const LongVector from = LongVector::UnitZ() * (tilt < 1.4e-6L ? -1 : 1);
      const LongVector x = turnedTheShortestWay(from, pole, LongVector::UnitX());
      for (const long double phi : {-2.5L, 0.4L, 1.1L})
        EXPECT_NEAR(valueOf("phi", stateAt(phi, pole, x), basis), static_cast<double>(phi), 1e-15)
            << static_cast<double>(tilt) << " " << static_cast<double>(side);
    }
}

// The five masses of the lecture's eq (2) to (12) in flight, 6 kg in total. Their sums are by hand (PHYSICS, eq 1
// to 10).
TEST(Quantities, MatchSumsByHandForAThrownBody) {
  physics::RigidBodyState s;
  s.t_s = 0.5;
  s.L_W = Vector3d(6.0150146484375, -7.01356201171875, 5.062939453125);
  s.kineticEnergy = 7.68713928222656;
  const physics::Flight flight{{0.34375, 0.09375, 0.0234375}, {1.2, -0.7, 0.4}, {0, 0, -9.81}};
  const scene::QuantityBasis basis{
      physics::PrincipalMoments(Vector3d(2, 3, 4)), {}, Vector3d(1, 2, 3), scene::ThrownBody{flight, 6}};
  const std::map<std::string_view, double> expected = {{"R_x", 0.34375 + 0.6},
                                                       {"R_y", 0.09375 - 0.35},
                                                       {"R_z", 0.0234375 + 0.2 - 9.81 / 8},
                                                       {"V_x", 1.2},
                                                       {"V_y", -0.7},
                                                       {"V_z", 0.4 - 4.905},
                                                       {"P_x", 7.2},
                                                       {"P_y", -4.2},
                                                       {"P_z", 6 * (0.4 - 4.905)},
                                                       {"L_orbital_x", 0.3234375 + 2.3911875},
                                                       {"L_orbital_y", -0.65625 + 18.9455625},
                                                       {"L_orbital_z", -2.11875},
                                                       {"L_total_x", 6.3384521484375 + 2.3911875},
                                                       {"L_total_y", -7.66981201171875 + 18.9455625},
                                                       {"L_total_z", 2.944189453125},
                                                       {"T_cm", 3 * (1.44 + 0.49 + 4.505 * 4.505)},
                                                       {"T_total", 7.68713928222656 + 3 * (1.93 + 4.505 * 4.505)},
                                                       {"V", 58.86 * (0.2234375 - 9.81 / 8)},
                                                       // No energy is lost: E keeps its value at the start.
                                                       {"E", 13.95713928222656 + 58.86 * 0.0234375}};
  for (const auto& [name, value] : expected)
    EXPECT_NEAR(valueOf(name, s, basis), value, 3e-14) << name;  // measured: at most 1.5e-14
}

// The five masses again, with the first of them as K. By hand, R x M V + R x (omega x M c) = R x P, where P =
// (7.2, -4.2, 2.4) kg m/s is the momentum of all: (0.15, 4.2, 6.9).
TEST(Quantities, MatchTheTermsByHandForAPointK) {
  Eigen::Matrix3d inertia;
  inertia << 8.5045166015625, -0.052734375, 1.06787109375, -0.052734375, 7.9420166015625, 2.19287109375,
      1.06787109375, 2.19287109375, 8.54296875;
  const Vector3d centre(0.34375, 0.09375, 0.0234375);
  const physics::Flight flight{centre, {1.2, -0.7, 0.4}, {0, 0, -9.81}};
  const physics::PrincipalAxes axes(inertia);
  physics::RigidBodyState s;
  s.omega_B = s.omega_W = Vector3d(0.6, -1.1, 0.8);
  s.L_W = inertia * s.omega_W;
  const scene::QuantityBasis basis{
      axes,
      {},
      axes.toP(s.omega_B),
      scene::ThrownBody{flight, 6, scene::ThrownPoint{{6, centre, inertia}, {0.5, -1.25, 0.75}}}};
  const auto vector = [&](const std::string& name) {
    return Vector3d(valueOf(name + "_x", s, basis), valueOf(name + "_y", s, basis),
                    valueOf(name + "_z", s, basis));
  };
  const Vector3d translation = vector("L_K_translation"), mixed = vector("L_K_mixed_1");
  EXPECT_LT((translation + mixed - Vector3d(0.15, 4.2, 6.9)).norm(), 1e-14);
  EXPECT_LT((vector("L_K_mixed_2") - Vector3d(-6.2967041015625, -6.65321044921875, -10.950732421875)).norm(),
            1e-14);
  // c x M (omega x c), with c = (-0.15625, 1.34375, -0.7265625), and I omega about the centre of mass.
  EXPECT_LT((vector("L_K_rotation") - s.L_W - Vector3d(6.4701416015625, 1.79696044921875, 1.931982421875)).norm(),
            1e-14);
  s.t_s = 0.5;
  const Vector3d sum =
      vector("L_K_translation") + vector("L_K_mixed_1") + vector("L_K_mixed_2") + vector("L_K_rotation");
  EXPECT_LT((sum - vector("L_total")).norm(), 1e-14);
}

TEST(Quantities, HaveNoMomentumForAThrownBodyWithoutMass) {
  const scene::QuantityBasis basis{
      physics::PrincipalMoments(Vector3d(2, 3, 4)), {}, Vector3d(1, 2, 3), scene::ThrownBody{}};
  physics::RigidBodyState s;
  s.kineticEnergy = 2;
  for (const char* name : {"P_x", "L_total_x", "L_orbital_y", "T_cm", "T_total"})
    EXPECT_TRUE(std::isnan(valueOf(name, s, basis))) << name;
  for (const char* name : {"E", "T"}) EXPECT_EQ(valueOf(name, s, basis), 2) << name;
}

TEST(Quantities, AreUndefinedForABodyAtRestIfTheyNeedL) {
  const scene::QuantityBasis basis{physics::PrincipalMoments(Vector3d(2, 3, 4)), {}, Vector3d::Zero()};
  for (const char* name : {"theta", "theta_omega", "h", "rho"})
    EXPECT_TRUE(std::isnan(valueOf(name, {}, basis))) << name;
  for (const char* name : {"omega", "L", "T", "theta_vertical"}) EXPECT_EQ(valueOf(name, {}, basis), 0) << name;
}

scene::Scene symmetricTop() {
  return scene::parseScene(
      "[body]\nprincipal_moments = [1.5, 1.5, 0.9]\n[motion]\nomega_body = [0.5, 0, 2]\n[time]\nspeed = 3\n"
      "start = 2\nduration = 20\n",
      "sample.toml");
}

// Books about tops count theta from the vertical, books about free bodies from L.
TEST(Quantities, NameTheThetaOfATopFromTheVertical) {
  physics::Forcing gravity;
  gravity.gravity_B = {0, 0, 0.3};
  const auto called = [](const char* name, const physics::Forcing& forcing) {
    return scene::quantityTex(indexOf(name), forcing);
  };
  EXPECT_EQ(called("theta", {}), "\\theta");
  EXPECT_EQ(called("theta_vertical", {}), "\\theta_z");
  EXPECT_EQ(called("theta", gravity), "\\theta_L");
  EXPECT_EQ(called("theta_vertical", gravity), "\\theta");
  EXPECT_EQ(called("phi", gravity), called("phi", {}));
}

// Expected from the lecture's numbers: phi turns at L/I1 (eq 34), psi at -Omega_p (eq 21), and theta is constant.
TEST(QuantityTrack, EulersAnglesOfATopGrowBeyondFullTurns) {
  const scene::Scene scene = symmetricTop();
  const QuantityTrack track(scene, drawnMotion(scene), {indexOf("phi"), indexOf("psi"), indexOf("theta")});
  const double precession = 1.95 / 1.5, spin = 0.8, theta = std::atan2(1.5 * 0.5, 0.9 * 2);
  const std::size_t last = track.samples() - 1;
  EXPECT_EQ(track.filmTime_s(last), 20);
  for (std::size_t i = 0; i <= last; ++i) {
    const double t = 3 * track.filmTime_s(i);
    EXPECT_NEAR(track.sample(0, i) - track.sample(0, 0), precession * t, 1e-12);  // measured 1.6e-13
    EXPECT_NEAR(track.sample(1, i) - track.sample(1, 0), spin * t, 1e-12);        // measured 6e-14
    EXPECT_NEAR(track.sample(2, i), theta, 1e-14);
  }
  for (double film_s = 0; film_s <= 20; film_s += 0.0637) {
    EXPECT_NEAR(track.at(0, film_s) - track.sample(0, 0), precession * 3 * film_s, 1e-12);
    EXPECT_NEAR(track.at(1, film_s) - track.sample(1, 0), spin * 3 * film_s, 1e-12);
  }
}

// The picture exaggerates the angle between omega and the axis 100 times. The numbers are those of the scene.
TEST(QuantityTrack, HasTheTrueNumbersIfAnglesAreExaggerated) {
  const scene::Scene scene = scene::parseScene(
      "[body]\nprincipal_moments = [2, 2, 3]\n[motion]\nomega_body = [0.001, 0, 1]\n[show]\n"
      "exaggerate_angles = 100\n",
      "small.toml");
  const QuantityTrack track(scene, drawnMotion(scene), {indexOf("omega_1"), indexOf("theta_omega")});
  EXPECT_NEAR(track.at(0, 0), 0.001, 1e-18);
  EXPECT_NEAR(track.at(1, 0), std::atan(0.001) - std::atan(0.001 * 2 / 3), 1e-15);
}

// q and -q are one attitude. The track keeps the sign along the film, so that no component jumps.
TEST(QuantityTrack, QuaternionsAreContinuous) {
  const scene::Scene scene = symmetricTop();
  const QuantityTrack track(scene, drawnMotion(scene),
                            {indexOf("q_w"), indexOf("q_x"), indexOf("q_y"), indexOf("q_z")});
  double square = 0, largest = 0;
  for (std::size_t i = 1; i < track.samples(); ++i)
    for (std::size_t part = 0; part < 4; ++part)
      largest = std::max(largest, std::abs(track.sample(part, i) - track.sample(part, i - 1)));
  for (std::size_t part = 0; part < 4; ++part) square += std::pow(track.at(part, 13.3), 2);
  // |dq| is at most |omega| dt/2.
  const double step_s = 3 * track.filmTime_s(1);
  EXPECT_LE(largest, 0.5 * std::sqrt(4.25) * step_s * 1.001);
  EXPECT_NEAR(square, 1, 1e-14);
  EXPECT_LT(track.range(0).low, -0.1);  // it does change sign
}

TEST(QuantityTrack, TakesFourSamplesPerPixelUpToABound) {
  scene::Scene scene = symmetricTop();
  EXPECT_GE(QuantityTrack(scene, drawnMotion(scene), {0}).samples(), 4u * 1920);
  scene.time.duration_s = 3600;
  scene.time.speed = 1000;  // 1.2 million turns
  EXPECT_EQ(QuantityTrack(scene, drawnMotion(scene), {0}).samples(), QuantityTrack::kMostSamples);
}

TEST(QuantityTrack, ReportsItsRange) {
  const scene::Scene scene = symmetricTop();
  const QuantityTrack track(scene, drawnMotion(scene), {indexOf("omega_1"), indexOf("omega_3")});
  // omega_1 = 0.5 cos: samples meet its ends to half the square of their step.
  EXPECT_NEAR(track.range(0).low, -0.5, 1e-5);
  EXPECT_NEAR(track.range(0).high, 0.5, 1e-5);
  EXPECT_NEAR(track.range(1).high - track.range(1).low, 0, 1e-14);
  EXPECT_EQ(track.range().high, track.range(1).high);
  EXPECT_NEAR(track.range().size, std::sqrt(4.25), 1e-12);
}

}  // namespace
}  // namespace poinsot::stage
