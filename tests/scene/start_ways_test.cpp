// SPDX-License-Identifier: Apache-2.0
// All pairs of ways to give a start: each is accepted with the meaning of both, or refused with both keys named.
#include "scene/keys/start_ways.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "physics/free_motion.h"
#include "scene/motion/make_motion.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using testing::HasSubstr;

const Vector3d kGravity_B(0, 0, 3);
const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

/// Start of a motion in vectors: the attitude, and omega and L in both axes.
struct Start {
  explicit Start(const Scene& scene)
      : q_WB(startOrientation(scene)),
        omega_B(scene.motion.omega_B),
        moments(scene.body.axes.moments().values()),
        L_B(moments.cwiseProduct(omega_B)),
        omega_W(q_WB * omega_B),
        L_W(q_WB * L_B),
        k_W(q_WB * kZ) {}
  Quaterniond q_WB;
  Vector3d omega_B, moments, L_B, omega_W, L_W, k_W;
};

/// Residual of what a way means, 0 if the start has this meaning. Each formula is a definition from a textbook.
using Residual = std::function<double(const Start&)>;

struct Sample {
  std::string_view way, key;
  std::string text;
  Residual residual;
};

double angleBetween(const Quaterniond& a, const Quaterniond& b) { return a.angularDistance(b); }

Quaterniond euler(double phi, double theta, double psi) {
  return AngleAxisd(phi, kZ) * AngleAxisd(theta, kX) * AngleAxisd(psi, kZ);
}

/// Residual of rates of Euler angles: the turn in a short time h, forwards and backwards, which leaves an error of
/// h².
double ratesResidual(const Start& start) {
  constexpr double kH = 1e-5;
  const Vector3d angles(0.3, 1, 0.2), rates(1, 0.5, 2);
  const bool given = angleBetween(start.q_WB, euler(0.3, 1, 0.2)) < 1e-9;
  const Vector3d at = given ? angles : Vector3d(0, 0, 0);
  const Vector3d after = at + kH * rates, before = at - kH * rates;
  const AngleAxisd turn(euler(after[0], after[1], after[2]) * euler(before[0], before[1], before[2]).conjugate());
  return (turn.angle() / (2 * kH) * turn.axis() - start.omega_W).norm() *
         1e-4;  // measured: 2e-10 before the factor
}

/// Residual of a steady precession: k turns about the vertical at the rate Omega, and the weight turns L alike.
double steadyResidual(const Start& start, double* rate = nullptr) {
  const Vector3d turned_W = start.omega_W.cross(start.k_W), around_W = kZ.cross(start.k_W);
  const double Omega = turned_W.dot(around_W) / around_W.squaredNorm();
  if (rate) *rate = Omega;
  const Vector3d torque_W = (start.q_WB * kGravity_B).cross(-kZ);
  const Vector3d turnedL_W = Omega * kZ.cross(start.L_W);
  return ((turned_W - Omega * around_W).norm() + (turnedL_W - torque_W).norm()) /
         (1 + start.omega_W.squaredNorm());
}

/// Residual of the periods P_phi and P_psi: after P_psi, omega returns in the body, and the long axis (here z) has
/// gone round L by 2 pi P_psi/P_phi, added up in short steps.
double periodsResidual(const Start& start, double phi_s, double psi_s) {
  const physics::FreeMotion motion(physics::PrincipalMoments(start.moments), start.omega_B, start.q_WB);
  const Vector3d pole_W = start.L_W.normalized(), x_W = pole_W.unitOrthogonal(), y_W = pole_W.cross(x_W);
  constexpr int kSteps = 400;
  double turned_rad = 0, before = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const Vector3d k_W = motion.at(psi_s * i / kSteps).q_WB * kZ;
    const double azimuth = std::atan2(k_W.dot(y_W), k_W.dot(x_W));
    if (i > 0) turned_rad += std::remainder(azimuth - before, 2 * std::numbers::pi);
    before = azimuth;
  }
  return std::abs(turned_rad * phi_s / (2 * std::numbers::pi * psi_s) - 1) +
         (motion.at(psi_s).omega_B - start.omega_B).norm() / start.omega_B.norm();
}

const std::vector<Sample>& samples() {
  static const std::vector<Sample> all = {
      {"omega_body", "omega_body", "omega_body=[0.1, 2, 3]",
       [](const Start& s) { return (s.omega_B - Vector3d(0.1, 2, 3)).norm(); }},
      {"omega_space", "omega_space", "omega_space=[0.1, 2, 3]",
       [](const Start& s) { return (s.omega_W - Vector3d(0.1, 2, 3)).norm(); }},
      {"L_body", "L_body", "L_body=[0.1, 2, 3]",
       [](const Start& s) { return (s.L_B - Vector3d(0.1, 2, 3)).norm(); }},
      {"L_space", "L_space", "L_space=[0.1, 2, 3]",
       [](const Start& s) { return (s.L_W - Vector3d(0.1, 2, 3)).norm(); }},
      {"spin and spin_axis", "spin", "spin=10\nspin_axis='3'",
       [](const Start& s) { return std::abs(s.omega_B.z() - 10); }},
      {"energy and L", "energy", "energy=40\nL=11",
       [](const Start& s) { return std::abs(s.L_B.norm() - 11) + std::abs(0.5 * s.omega_B.dot(s.L_B) - 40); }},
      {"P_phi and P_psi", "P_phi", "P_phi=10\nP_psi=21\nmode='SAM'",
       [](const Start& s) { return periodsResidual(s, 10, 21); }},
      {"euler_rates", "euler_rates", "euler_rates={precession=1, nutation=0.5, spin=2}", ratesResidual},
      {"a rate of precession", "precession", "precession=1.5",
       [](const Start& s) {
         double rate = 0;
         const double residual = steadyResidual(s, &rate);
         return residual + std::abs(rate - 1.5);
       }},
      {"tilt", "tilt", "tilt=0.3",
       [](const Start& s) { return std::abs(std::atan2(s.L_B.cross(kZ).norm(), s.L_B.z()) - 0.3); }},
      {"precession slow or fast", "precession", "precession='fast'",
       [](const Start& s) { return steadyResidual(s); }},
      {"nutation", "nutation", "nutation='cusps'",  // the axis is released at rest
       [](const Start& s) { return s.omega_W.cross(s.k_W).norm(); }},
      {"lean", "lean", "lean=1.1",
       [](const Start& s) { return (s.k_W - Vector3d(0, -std::sin(1.1), std::cos(1.1))).norm(); }},
      {"euler", "euler", "euler={precession=0.3, nutation=1, spin=0.2}",
       [](const Start& s) { return angleBetween(s.q_WB, euler(0.3, 1, 0.2)); }},
      {"roll_pitch_yaw", "roll_pitch_yaw", "roll_pitch_yaw=[0.4, 0.5, 0.6]",
       [](const Start& s) {
         return angleBetween(s.q_WB, AngleAxisd(0.6, kZ) * AngleAxisd(0.5, kY) * AngleAxisd(0.4, kX));
       }},
      {"orientation", "orientation", "orientation=[1, 1, 0.5, 0]",
       [](const Start& s) { return angleBetween(s.q_WB, Quaterniond(1, 1, 0.5, 0).normalized()); }},
  };
  return all;
}

// Written by hand, in the order of the samples. y means that the pair of the row
// and a later column combines. Rotations exclude
// each other, and so do attitudes. Tilt, precession slow or fast, and nutation are properties of a spin. Rates of
// Euler angles need these angles.
constexpr std::string_view kPairs[] = {
    "nnnnnnnnnnnyyyy",  // omega_body
    "nnnnnnnnnnyyyy",   // omega_space
    "nnnnnnnnnyyyy",    // L_body
    "nnnnnnnnyyyy",     // L_space
    "nnnnyyyyyyy",      // spin and spin_axis
    "nnnnnnyyyy",       // energy and L
    "nnnnnyyyy",        // P_phi and P_psi
    "nnnnnynn",         // euler_rates
    "nnnyyyy",          // a rate of precession
    "nnyyyy",           // tilt
    "nyyyy",            // precession slow or fast
    "yyyy",             // nutation
    "nnn",              // lean
    "nn",               // euler
    "n",                // roll_pitch_yaw
};

bool isTop(const Sample& s) { return s.key == "precession" || s.key == "nutation"; }
StartPart partOf(const Sample& s) { return startWay(s.way).part; }

/// Returns a scene with two ways, and with what these need in addition.
std::string sceneWith(const Sample& a, const Sample& b) {
  const std::string moments = isTop(a) || isTop(b) ? "[2, 2, 1]" : "[2, 1.5, 1]";
  std::string text = "body.principal_moments=" + moments + "\n[motion]\n" + a.text + "\n" + b.text + "\n";
  const auto has = [&](StartPart part) { return partOf(a) == part || partOf(b) == part; };
  const bool needsSpin = !has(StartPart::kRotation) && (has(StartPart::kTilt) || has(StartPart::kTop));
  if (isTop(a) || isTop(b)) text += "gravity.mgr_body=[0, 0, 3]\n";
  if (needsSpin) text += "spin=10\nspin_axis='3'\n";
  if ((isTop(a) || isTop(b)) && !has(StartPart::kAttitude)) text += "lean=1.1\n";
  const bool leansWithoutAxis =
      (a.way == "lean" || b.way == "lean") && text.find("spin_axis") == std::string::npos;
  return leansWithoutAxis ? text + "spin_axis='3'\n" : text;
}

TEST(StartWays, AreAllSampled) {
  ASSERT_EQ(samples().size(), startWays().size());
  for (std::size_t i = 0; i < samples().size(); ++i) EXPECT_EQ(samples()[i].way, startWays()[i].name);
}

// Measured: 3e-15, except rates of Euler angles.
TEST(StartWays, CombineWithTheMeaningOfBothOrNameBoth) {
  int accepted = 0;
  for (std::size_t i = 0; i + 1 < samples().size(); ++i)
    for (std::size_t j = i + 1; j < samples().size(); ++j) {
      const Sample &a = samples()[i], &b = samples()[j];
      const bool combined = kPairs[i][j - i - 1] == 'y';
      EXPECT_EQ(combine(startWay(a.way), startWay(b.way)), combined) << a.way << ", " << b.way;
      EXPECT_EQ(combine(startWay(b.way), startWay(a.way)), combined) << b.way << ", " << a.way;
      if (a.key == b.key) continue;  // one key cannot be given twice
      const std::string text = sceneWith(a, b);
      const std::string message = messagesOf(text);
      if (!combined) {
        EXPECT_THAT(message, HasSubstr(fmt::format("motion.{}", a.key))) << text;
        EXPECT_THAT(message, HasSubstr(fmt::format("motion.{}", b.key))) << text;
        continue;
      }
      ++accepted;
      ASSERT_EQ(message, "") << text;
      const Start start(parseScene(text, "test.toml"));
      EXPECT_LE(a.residual(start), 1e-13) << text;
      EXPECT_LE(b.residual(start), 1e-13) << text;
    }
  EXPECT_EQ(accepted, 48);  // as many as there are y above
}

TEST(StartWays, AreListedInAMarkdownTable) {
  EXPECT_THAT(startWaysMarkdown(), HasSubstr("| | tilt | precession slow or fast | nutation | lean | euler |"));
  EXPECT_THAT(startWaysMarkdown(), HasSubstr("| euler_rates | no | no | no | no | yes | no | no |\n"));
}

// ---- tops

const std::string kTop = "body.principal_moments=[2, 2, 1]\n[motion]\ngravity.mgr_body=[0, 0, 3]\n";

std::string topProblems(const std::string& motion) { return messagesOf(kTop + motion); }

// Worked out by hand: at 60 deg, I3 omega_3 must be at least 2 sqrt(I1 M g l cos 60 deg) = 3.4641.
TEST(TopStart, TellsWhatATopWithoutThisMotionNeeds) {
  EXPECT_EQ(
      topProblems("lean='60 deg'\nspin=3.4\nspin_axis='3'\nprecession='slow'"),
      "motion.precession: needs a faster spin: a lean of 60 deg precesses steadily only with |motion.spin| of "
      "at least 3.4641 rad/s (0.5513 rev/s)\n");
  EXPECT_EQ(topProblems("lean='60 deg'\nspin=3.47\nspin_axis='3'\nprecession='slow'"), "");
  EXPECT_EQ(
      topProblems("lean='90 deg'\nspin=5\nspin_axis='3'\nprecession='fast'"),
      "motion.precession: has no fast precession, because the axis is level; give \"slow\", or another lean\n");
  EXPECT_EQ(
      topProblems("spin=5\nspin_axis='3'\nnutation='cusps'"),
      "motion.nutation: needs a top that leans: its axis is vertical; give motion.lean, such as \"60 deg\"\n");
  EXPECT_EQ(topProblems("lean=1\nspin=5\nspin_axis='1'\nnutation='cusps'"),
            "motion.nutation: needs a spin about the axis of symmetry; give another motion.spin_axis\n");
  EXPECT_EQ(topProblems("lean=1\nspin=0\nspin_axis='3'\nnutation='cusps'"),
            "motion.nutation: needs a spin; without it the body is a pendulum\n");
  const std::string slow = "lean=1\nspin=5\nspin_axis='3'\nprecession='slow'\n";
  EXPECT_EQ(messagesOf("body.principal_moments=[2, 2, 1]\n[motion]\n" + slow),
            "motion.precession: needs gravity: give motion.gravity\n");
  EXPECT_EQ(messagesOf("body.principal_moments=[2, 3, 4]\n[motion]\ngravity.mgr_body=[0, 0, 3]\n" + slow),
            "motion.precession: needs a symmetric body whose centre of mass lies on the axis of symmetry\n");
  EXPECT_EQ(topProblems("precession='slow'\nlean=1"),
            "motion.precession: motion.spin is missing: give spin and spin_axis together. For example:\n    spin "
            "= \"3 rev/s\"\n");
}

TEST(TopStart, LeansItsOwnAxisUnderGravity) {
  const auto kOf = [](const std::string& text) { return Vector3d(startOrientation(parseScene(text, "t")) * kZ); };
  const std::string hanging = "body.principal_moments=[2, 2, 1]\n[motion]\ngravity.mgr_body=[0, 0, -3]\n";
  // The line to the centre of mass is -z, and leans by 60 deg.
  EXPECT_NEAR(kOf(hanging + "lean='60 deg'\nomega_body=[0, 0, 1]").z(), -0.5, 1e-15);
  EXPECT_NEAR(kOf(hanging + "lean='60 deg'\nspin=1\nspin_axis='3'").z(), 0.5, 1e-15);
}

TEST(TopStart, NeedsAnAxisThatLeansInFreeMotion) {
  EXPECT_EQ(messagesOf("body.principal_moments=[1, 2, 3]\nmotion.omega_body=[0, 0, 1]\nmotion.lean=1"),
            "motion.lean: motion.spin_axis is missing: it names the axis that leans; without gravity, no axis is "
            "marked. For example:\n    spin_axis = \"largest\"\n");
}

// Oracle: the integrated motion, by the sign of phi' where theta is least and where it is largest.
TEST(TopStart, NutatesAsNamed) {
  const std::pair<const char*, double> kinds[] = {{"cusps", 0}, {"loops", -1}, {"waves", 1}};
  for (const double lean : {0.4, 1.0, 1.9})
    for (const double spin : {8.0, -11.0})
      for (const auto& [name, sign] : kinds) {
        const Scene scene = parseScene(
            kTop + fmt::format("lean={}\nspin={}\nspin_axis='3'\nnutation='{}'", lean, spin, name), "test.toml");
        const auto motion = makeMotion(scene, 0, 3);
        double largest = 0, leastLean = 4, most = 0;
        for (int i = 0; i <= 3000; ++i) {
          const auto state = motion->at(i * 1e-3);
          const Vector3d k_W = state.q_WB * kZ, turned_W = state.omega_W.cross(k_W);
          const double theta = std::acos(k_W.z());
          const double rate = turned_W.dot(kZ.cross(k_W)) / kZ.cross(k_W).squaredNorm();
          leastLean = std::min(leastLean, theta);
          if (theta > largest) largest = theta, most = rate;
        }
        EXPECT_NEAR(leastLean, lean, 1e-9) << name;  // the start is the least lean
        EXPECT_GT(largest, lean + 1e-3);
        EXPECT_GT(most * spin, 0) << name;
        const Start start(scene);
        const double first = start.omega_W.cross(start.k_W).dot(kZ.cross(start.k_W));
        EXPECT_EQ(std::abs(first) < 1e-12 ? 0.0 : std::copysign(1.0, first * spin), sign) << name;
      }
}

}  // namespace
}  // namespace poinsot::scene
