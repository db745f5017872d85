// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

// Angular momentum is a moment of inertia times a spin, energy a moment times the square of a spin.
constexpr Range kMomenta{.least = kLeastMoment * kLeastSpin, .most = kMostMoment * kMostSpin, .ofSize = true};
constexpr Range kLengthOfL{.least = kLeastMoment * kLeastSpin, .most = kMostMoment * kMostSpin};
constexpr Range kEnergies{.least = 1e-140, .most = 1e140};
constexpr Range kTilts{.least = 0, .most = 89.999, .unit = "deg"};  // at 90 deg, the spin about the axis is 0
constexpr Range kPeriods{.least = 1e-20, .most = 1e20};
constexpr Range kLeans{.least = 0, .most = 180, .unit = "deg"};
constexpr Range kTiltSides{.least = -360, .most = 360, .unit = "deg"};
constexpr Range kPhases{.least = 0, .most = 0.999999999};   // 1 is the same phase as 0
constexpr Range kTolerances{.least = 1e-14, .most = 1e-3};  // between rounding errors and visible errors

std::vector<Key> vectorStartKeys() {
  return {
      {.path = "motion.omega_body",
       .type = kVector,
       .dimension = kAngularVelocity,
       .range = kSpins,
       .example = "[0.01, \"3 rpm\", 0]",
       .help =
           "Angular velocity at motion time 0, in components along the body's axes. A scene gives the rotation in "
           "exactly one way, such as this one.",
       .put = into([](Draft& d) { return &d.start.omega_B; })},
      {.path = "motion.omega_space",
       .type = kVector,
       .dimension = kAngularVelocity,
       .range = kSpins,
       .example = "[0, 0, \"3 rpm\"]",
       .help = "Angular velocity at motion time 0, in components along the world's axes.",
       .put = into([](Draft& d) { return &d.start.omega_W; })},
      {.path = "motion.L_body",
       .type = kVector,
       .dimension = kAngularMomentum,
       .range = kMomenta,
       .example = "[0, 0.2, 2]",
       .help = "Angular momentum at motion time 0, in components along the body's axes.",
       .put = into([](Draft& d) { return &d.start.L_B; })},
      {.path = "motion.L_space",
       .type = kVector,
       .dimension = kAngularMomentum,
       .range = kMomenta,
       .example = "[0, 0, 2]",
       .help = "Angular momentum at motion time 0, in components along the world's axes.",
       .put = into([](Draft& d) { return &d.start.L_W; })},
  };
}

std::vector<Key> spinKeys() {
  return {
      {.path = "motion.spin",
       .dimension = kAngularVelocity,
       .range = kSpins,
       .example = "\"3 rev/s\"",
       .help =
           "Component of the angular velocity omega along spin_axis. In free motion, the angular momentum L is "
           "then "
           "vertical, and spin_axis leans from L by the angle `tilt`. If the body is thrown end over end, give "
           "omega_space instead of spin.",
       .put = into([](Draft& d) { return &d.start.spin; })},
      {.path = "motion.spin_axis",
       .type = kWord,
       .words = {"1", "2", "3", "smallest", "middle", "largest"},
       .example = "\"middle\"",
       .help = "Principal axis about which the body spins. Name the axis by its number or by its moment. If the "
               "body's axes are principal axes, the numbers 1, 2 and 3 are x, y and z. Otherwise, the numbers are "
               "in order of moment.",
       .put = into([](Draft& d) { return &d.start.spinAxis; })},
      {.path = "motion.tilt",
       .dimension = kAngle,
       .range = kTilts,
       .example = "\"2 deg\"",
       .help = "Angle between the angular momentum L and spin_axis. The default is 0, which is a steady spin. "
               "Under gravity, give lean instead.",
       .put = into([](Draft& d) { return &d.start.tilt; })},
      {.path = "motion.tilt_towards",
       .dimension = kAngle,
       .range = kTiltSides,
       .example = "\"90 deg\"",
       .help = "Side towards which the angular momentum L leans from spin_axis, as an angle. At 0, the default, L "
               "leans towards the principal axis that follows spin_axis in the order 1, 2, 3, 1. At 90 deg, L "
               "leans towards the axis after that one.",
       .put = into([](Draft& d) { return &d.start.tiltTowards; })},
  };
}

std::vector<Key> energyKeys() {
  return {
      {.path = "motion.energy",
       .dimension = kEnergy,
       .range = kEnergies,
       .example = "\"4.5 J\"",
       .help = "Kinetic energy of rotation. Together with L, it sets the polhode.",
       .put = into([](Draft& d) { return &d.start.energy; })},
      {.path = "motion.L",
       .dimension = kAngularMomentum,
       .range = kLengthOfL,
       .example = "4.2",
       .help = "Magnitude of the angular momentum. It must be from sqrt(2 T I1) to sqrt(2 T I3). T is the kinetic "
               "energy, I1 the least moment and I3 the largest moment.",
       .put = into([](Draft& d) { return &d.start.L; })},
      {.path = "motion.phase",
       .range = kPhases,
       .example = "0.25",
       .help = "Point of the polhode (the path of omega in the body) at which the motion starts. The point is "
               "given as a fraction of the polhode's period. At 0, the default, L has no component along the axis "
               "of middle moment.",
       .put = into([](Draft& d) { return &d.start.phase; })},
      {.path = "motion.branch",
       .type = kWord,
       .words = {"positive", "negative"},
       .example = "\"negative\"",
       .help = "Choice between the two polhodes that have the given energy and L. Both go round the same "
               "principal axis. `positive`, the default, goes round the positive half of this axis, and "
               "`negative` goes round the negative half.",
       .put = into([](Draft& d) { return &d.start.branch; })},
  };
}

std::vector<Key> periodKeys() {
  return {
      {.path = "motion.P_phi",
       .dimension = kTime,
       .range = kPeriods,
       .example = "\"27.4 h\"",
       .help = "Mean period in which the long axis of a tumbling body goes round L, as in tables of asteroids. "
               "Give P_psi "
               "too.",
       .put = into([](Draft& d) { return &d.start.periodPhi; })},
      {.path = "motion.P_psi",
       .dimension = kTime,
       .range = kPeriods,
       .example = "\"264 h\"",
       .help =
           "Period of the rotation about the long axis of a tumbling body: of a full turn (LAM), or of a swing "
           "(SAM).",
       .put = into([](Draft& d) { return &d.start.periodPsi; })},
      {.path = "motion.mode",
       .type = kWord,
       .words = {"SAM", "LAM"},
       .example = "\"SAM\"",
       .help = "Axis that L circles in the body, if two rotations have the same P_phi and P_psi: the short axis "
               "(SAM), or "
               "the long axis (LAM).",
       .put = into([](Draft& d) { return &d.start.mode; })},
  };
}

std::vector<Key> topKeys() {
  return {
      {.path = "motion.precession",
       .dimension = kAngularVelocity,
       .range = kSpins,
       .words = {"slow", "fast"},
       .example = "\"slow\"",
       .help =
           "Steady precession of a symmetric top under gravity, at the lean that the scene gives. With spin and "
           "spin_axis, `slow` or `fast` chooses one of the two rates at which this spin precesses. Without spin, "
           "a rate sets the spin. A whole start is spin = \"25 rev/s\", spin_axis = \"3\", lean = \"50 deg\" and "
           "precession = \"slow\", beside [motion.gravity] with g = 9.81 and a body with a mass and a pivot.",
       .put =
           [](Draft& d, std::size_t, const Checked& value) {
             const auto* word = std::get_if<Word>(&value);
             if (word)
               d.start.steady = static_cast<PrecessionWord>(word->index);
             else
               d.start.precession = std::get<double>(value);
           }},
      {.path = "motion.nutation",
       .type = kWord,
       .words = {"cusps", "loops", "waves"},
       .example = "\"cusps\"",
       .help =
           "Nutation of a symmetric top under gravity, which starts at its least lean. With `cusps`, its axis is "
           "released at rest, and comes to rest at each least lean. With `loops`, the axis starts backwards, and "
           "with `waves` forwards, at half the rate of the slow steady precession.",
       .put =
           [](Draft& d, std::size_t, const Checked& value) {
             constexpr physics::NutationKind kKinds[] = {
                 physics::NutationKind::kCusps, physics::NutationKind::kLoops, physics::NutationKind::kWaves};
             d.start.nutation = kKinds[std::get<Word>(value).index];
           }},
  };
}

Key eulerKey(std::string path, std::string_view example, std::string_view help, Range range,
             double physics::EulerAngles::*angle) {
  return {.path = "motion.euler." + path,
          .dimension = kAngle,
          .range = range,
          .fallback = "0",
          .example = example,
          .help = help,
          .put = into([angle](Draft& d) { return &(d.start.euler.*angle); })};
}

Key eulerRateKey(std::string path, std::string_view help, double physics::EulerAngles::*rate) {
  return {.path = "motion.euler_rates." + path,
          .dimension = kAngularVelocity,
          .range = kSpins,
          .fallback = "0",
          .example = "\"20 rpm\"",
          .help = help,
          .put = into([rate](Draft& d) { return &(d.start.eulerRates.*rate); })};
}

std::vector<Key> eulerKeys() {
  using E = physics::EulerAngles;
  return {
      eulerKey(
          "precession", "\"30 deg\"",
          "Angle phi of the Euler angles in the order z, x, z, at motion time 0. The body is turned by `spin` "
          "about the world's z, then by `nutation` about the world's x, then by `precession` about the world's "
          "z.",
          kFullTurns, &E::precession),
      eulerKey("nutation", "\"60 deg\"", "Angle theta between the body's z axis and the world's z axis.", kLeans,
               &E::nutation),
      eulerKey("spin", "\"45 deg\"", "Angle psi by which the body is turned about its own z axis.", kFullTurns,
               &E::spin),
      eulerRateKey("precession", "Rate of the Euler angle phi: the body turns about the world's z.",
                   &E::precession),
      eulerRateKey("nutation",
                   "Rate of the Euler angle theta: the body turns about the line of nodes, at right angles to the "
                   "world's z and the body's z.",
                   &E::nutation),
      eulerRateKey("spin", "Rate of the Euler angle psi: the body turns about its own z.", &E::spin),
  };
}

std::vector<Key> attitudeKeys() {
  return {
      {.path = "motion.lean",
       .dimension = kAngle,
       .range = kLeans,
       .example = "\"60 deg\"",
       .help =
           "Angle at motion time 0 between the world's z and spin_axis. Under gravity, spin_axis may be left out; "
           "the line from the fixed point to the centre of mass then leans. The axis leans towards -y. In free "
           "motion, lean turns the body together with L; the angle between L and spin_axis is tilt.",
       .put = into([](Draft& d) { return &d.start.lean; })},
      {.path = "motion.roll_pitch_yaw",
       .type = kVector,
       .dimension = kAngle,
       .range = kFullTurns,
       .example = "[\"10 deg\", 0, \"90 deg\"]",
       .help =
           "Roll, pitch and yaw of the body at motion time 0, as for aircraft and robots. From the world's axes, "
           "the body is turned by the yaw about its z, then by the pitch about its new y, then by the roll about "
           "its newest x.",
       .put = into([](Draft& d) { return &d.start.rollPitchYaw; })},
      {.path = "motion.orientation",
       .type = kQuaternion,
       .range = kQuaternionNorm,
       .example = "[1, 0, 0, 0]",
       .help = "Quaternion w, x, y, z that takes body axes to world axes at motion time 0. The quaternion is "
               "normalised on reading. By default, the body is turned so that L is vertical and the invariable "
               "plane is level. If the start is given in world axes, body and world axes agree instead. They also "
               "agree under gravity, torque or drag. For example, a top that leans by an angle a from z towards "
               "-y has [cos(a/2), sin(a/2), 0, 0].",
       .put = into([](Draft& d) { return &d.scene.motion.orientation_WB; })},
      {.path = "motion.L_points",
       .type = kWord,
       .words = {"auto", "down", "up"},
       .fallback = "\"auto\"",
       .example = "\"up\"",
       .help = "Direction of the angular momentum L, up or down, if the scene gives no motion.orientation. `auto` "
               "is down if the invariable plane is shown, so that the ellipsoid rolls on the plane as on a table. "
               "Otherwise, `auto` is up.",
       .put = into([](Draft& d) { return &d.scene.motion.lPoints; })},
      {.path = "motion.tolerance",
       .dimension = kAngle,
       .range = kTolerances,
       .fallback = "1e-12",
       .example = "1e-9",
       .help = "Largest error that the attitude may have at any time of the run, if gravity, torque, drag or "
               "dissipation acts. Free motion does not depend on this key, because it is computed exactly, to "
               "rounding.",
       .put = into([](Draft& d) { return &d.scene.motion.tolerance_rad; })},
  };
}

}  // namespace

std::vector<Key> motionKeys() {
  return joined(
      {vectorStartKeys(), spinKeys(), topKeys(), energyKeys(), periodKeys(), attitudeKeys(), eulerKeys()});
}

}  // namespace poinsot::scene
