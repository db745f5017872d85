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
       .help = "Angular velocity at motion time 0, in components along the body's axes. A start is given by this "
               "key, omega_space, L_body, L_space, spin, or energy and L.",
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
       .help = "Component of omega along spin_axis. L is vertical, and spin_axis leans from L by `tilt`. For a "
               "throw end over end, give omega_space instead.",
       .put = into([](Draft& d) { return &d.start.spin; })},
      {.path = "motion.spin_axis",
       .type = kWord,
       .words = {"1", "2", "3", "smallest", "middle", "largest"},
       .example = "\"middle\"",
       .help = "Principal axis of the spin, by number or by moment. If the body's axes are principal axes, 1, 2 "
               "and 3 are x, y and z. Otherwise they are in order of moment.",
       .put = into([](Draft& d) { return &d.start.spinAxis; })},
      {.path = "motion.tilt",
       .dimension = kAngle,
       .range = kTilts,
       .example = "\"2 deg\"",
       .help =
           "Angle between L and spin_axis. By default 0, which is a steady spin. Under gravity, tilt is an error: "
           "lean the body with motion.orientation instead. The error message contains the value for it.",
       .put = into([](Draft& d) { return &d.start.tilt; })},
      {.path = "motion.tilt_towards",
       .dimension = kAngle,
       .range = kTiltSides,
       .example = "\"90 deg\"",
       .help = "Side towards which L leans by `tilt`, as an angle. At 0, the default, L leans to the principal "
               "axis after spin_axis in the order 1, 2, 3, 1. At 90 deg, L leans to the axis after that.",
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
       .help = "Magnitude of the angular momentum. It must be from sqrt(2 T I1) to sqrt(2 T I3), where I1 is the "
               "least and I3 the largest moment.",
       .put = into([](Draft& d) { return &d.start.L; })},
      {.path = "motion.phase",
       .range = kPhases,
       .example = "0.25",
       .help = "Point of the polhode at which the motion starts, as a fraction of the polhode's period. At 0, the "
               "default, L has no component along the axis of middle moment.",
       .put = into([](Draft& d) { return &d.start.phase; })},
      {.path = "motion.branch",
       .type = kWord,
       .words = {"positive", "negative"},
       .example = "\"negative\"",
       .help = "One of the two polhodes with this energy and L. `positive`, the default, goes round the positive "
               "half of the polhode's axis, `negative` round the negative half.",
       .put = into([](Draft& d) { return &d.start.branch; })},
  };
}

std::vector<Key> attitudeKeys() {
  return {
      {.path = "motion.orientation",
       .type = kQuaternion,
       .range = kQuaternionNorm,
       .example = "[1, 0, 0, 0]",
       .help = "Quaternion w, x, y, z that takes body axes to world axes at motion time 0. It is normalised on "
               "reading. By default, L is turned onto the vertical, so that the invariable plane is level. If the "
               "start is given in world axes, or under gravity, torque or drag, body and world axes agree "
               "instead. A top that leans by an angle a from z towards -y has [cos(a/2), sin(a/2), 0, 0].",
       .put = into([](Draft& d) { return &d.scene.motion.orientation_WB; })},
      {.path = "motion.L_points",
       .type = kWord,
       .words = {"auto", "down", "up"},
       .fallback = "\"auto\"",
       .example = "\"up\"",
       .help = "Direction of L, up or down, if no orientation is given. `auto` is down if the plane is shown, so "
               "that the ellipsoid rolls on the plane as on a table. Otherwise, `auto` is up.",
       .put = into([](Draft& d) { return &d.scene.motion.lPoints; })},
      {.path = "motion.tolerance",
       .dimension = kAngle,
       .range = kTolerances,
       .fallback = "1e-12",
       .example = "1e-9",
       .help = "Largest error of the attitude over the run under gravity, torque, drag or dissipation. Free "
               "motion is exact to rounding.",
       .put = into([](Draft& d) { return &d.scene.motion.tolerance_rad; })},
  };
}

}  // namespace

std::vector<Key> motionKeys() { return joined({vectorStartKeys(), spinKeys(), energyKeys(), attitudeKeys()}); }

}  // namespace poinsot::scene
