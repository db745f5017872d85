// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

// Limits of moments times spins; energies are moments times squared spins.
constexpr Range kMomenta{.least = kLeastMoment * kLeastSpin, .most = kMostMoment * kMostSpin, .ofSize = true};
constexpr Range kLengthOfL{.least = kLeastMoment * kLeastSpin, .most = kMostMoment * kMostSpin};
constexpr Range kEnergies{.least = 1e-140, .most = 1e140};
constexpr Range kTilts{.least = 0, .most = 89.999, .unit = "deg"};  // at 90 deg the spin about the axis vanishes
constexpr Range kTiltSides{.least = -360, .most = 360, .unit = "deg"};
constexpr Range kPhases{.least = 0, .most = 0.999999999};   // 1 would be the same as 0
constexpr Range kTolerances{.least = 1e-14, .most = 1e-3};  // below, rounding decides; above, errors are visible

std::vector<Key> vectorStartKeys() {
  return {
      {.path = "motion.omega_body",
       .type = kVector,
       .dimension = kAngularVelocity,
       .range = kSpins,
       .example = "[0.01, \"3 rpm\", 0]",
       .help =
           "Angular velocity at motion time 0, components along the body's axes. This, or omega_space, L_body, "
           "L_space, spin, or energy and L.",
       .put = into([](Draft& d) { return &d.start.omega_B; })},
      {.path = "motion.omega_space",
       .type = kVector,
       .dimension = kAngularVelocity,
       .range = kSpins,
       .example = "[0, 0, \"3 rpm\"]",
       .help = "Angular velocity at motion time 0, components along the world's axes.",
       .put = into([](Draft& d) { return &d.start.omega_W; })},
      {.path = "motion.L_body",
       .type = kVector,
       .dimension = kAngularMomentum,
       .range = kMomenta,
       .example = "[0, 0.2, 2]",
       .help = "Angular momentum at motion time 0, components along the body's axes.",
       .put = into([](Draft& d) { return &d.start.L_B; })},
      {.path = "motion.L_space",
       .type = kVector,
       .dimension = kAngularMomentum,
       .range = kMomenta,
       .example = "[0, 0, 2]",
       .help = "Angular momentum at motion time 0, components along the world's axes.",
       .put = into([](Draft& d) { return &d.start.L_W; })},
  };
}

std::vector<Key> spinKeys() {
  return {
      {.path = "motion.spin",
       .dimension = kAngularVelocity,
       .range = kSpins,
       .example = "\"3 rev/s\"",
       .help = "Component of omega along spin_axis, with L leaning from that axis by tilt. L stands upright; for "
               "a throw "
               "end over end give omega_space.",
       .put = into([](Draft& d) { return &d.start.spin; })},
      {.path = "motion.spin_axis",
       .type = kWord,
       .words = {"1", "2", "3", "smallest", "middle", "largest"},
       .example = "\"middle\"",
       .help = "Principal axis that spin is about: by its place (1, 2, 3 are x, y, z where the body's axes are "
               "principal axes, else in order of moment), or by its moment.",
       .put = into([](Draft& d) { return &d.start.spinAxis; })},
      {.path = "motion.tilt",
       .dimension = kAngle,
       .range = kTilts,
       .example = "\"2 deg\"",
       .help = "Angle between L and spin_axis; without it, none: a steady spin. Refused under gravity, where "
               "motion.orientation leans a body: the message has its value.",
       .put = into([](Draft& d) { return &d.start.tilt; })},
      {.path = "motion.tilt_towards",
       .dimension = kAngle,
       .range = kTiltSides,
       .example = "\"90 deg\"",
       .help = "With tilt, the side that L leans to: 0 is the principal axis after spin_axis in the order 1, 2, "
               "3, 1, and 90 "
               "deg the one after that. Without it, 0.",
       .put = into([](Draft& d) { return &d.start.tiltTowards; })},
  };
}

std::vector<Key> energyKeys() {
  return {
      {.path = "motion.energy",
       .dimension = kEnergy,
       .range = kEnergies,
       .example = "\"4.5 J\"",
       .help = "Kinetic energy of rotation; together with L it sets the polhode.",
       .put = into([](Draft& d) { return &d.start.energy; })},
      {.path = "motion.L",
       .dimension = kAngularMomentum,
       .range = kLengthOfL,
       .example = "4.2",
       .help =
           "Magnitude of the angular momentum; from sqrt(2 T I1) to sqrt(2 T I3) for the least and the largest "
           "moment.",
       .put = into([](Draft& d) { return &d.start.L; })},
      {.path = "motion.phase",
       .range = kPhases,
       .example = "0.25",
       .help =
           "Where on the polhode the motion starts, in parts of its period: at 0, L has no component along the "
           "axis of middle moment. Without it, 0.",
       .put = into([](Draft& d) { return &d.start.phase; })},
      {.path = "motion.branch",
       .type = kWord,
       .words = {"positive", "negative"},
       .example = "\"negative\"",
       .help = "Which of the two polhodes: round the positive half of its axis, as without this key, or round the "
               "negative one.",
       .put = into([](Draft& d) { return &d.start.branch; })},
  };
}

std::vector<Key> attitudeKeys() {
  return {
      {.path = "motion.orientation",
       .type = kQuaternion,
       .range = kQuaternionNorm,
       .example = "[1, 0, 0, 0]",
       .help = "Quaternion w, x, y, z taking body axes to world axes at motion time 0, normalised on reading. "
               "Without it, L is turned onto the vertical, so that the invariable plane is level; but body and "
               "world axes agree where the start is given in world axes, and under gravity, torque or drag. A "
               "top that leans by an angle a from z towards -y has [cos(a/2), sin(a/2), 0, 0].",
       .put = into([](Draft& d) { return &d.scene.motion.orientation_WB; })},
      {.path = "motion.L_points",
       .type = kWord,
       .words = {"auto", "down", "up"},
       .fallback = "\"auto\"",
       .example = "\"up\"",
       .help = "Which way L points where no orientation is given, up or down; auto is down where the plane is "
               "shown, so that "
               "the ellipsoid rolls on it as on a table, and up elsewhere.",
       .put = into([](Draft& d) { return &d.scene.motion.lPoints; })},
      {.path = "motion.tolerance",
       .dimension = kAngle,
       .range = kTolerances,
       .fallback = "1e-12",
       .example = "1e-9",
       .help =
           "Largest error of attitude over the run where gravity, torque, drag or dissipation act; free motion "
           "is exact to rounding.",
       .put = into([](Draft& d) { return &d.scene.motion.tolerance_rad; })},
  };
}

}  // namespace

std::vector<Key> motionKeys() { return joined({vectorStartKeys(), spinKeys(), energyKeys(), attitudeKeys()}); }

}  // namespace poinsot::scene
