// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

// Range of a torque. The largest torque is a moment of inertia times the square of a spin.
constexpr Range kTorques{.least = 1e-140, .most = kMostTorque, .ofSize = true};
constexpr Range kAccelerations{.least = 1e-12, .most = 1e12, .ofSize = true};
constexpr Range kVelocities{.least = 1e-12, .most = 1e12, .ofSize = true};
constexpr Range kForces{.least = 1e-30, .most = 1e30, .ofSize = true};
constexpr Range kForceName{.least = 0, .most = 80};
constexpr Range kPull{.least = 0, .most = 1e12};
constexpr Range kPullOnTable{.least = 1e-12, .most = 1e12};
constexpr Range kRates{.least = 0, .most = 1e20};  // decay rates; rate times time is an exponent
constexpr Range kAlphas{.least = 0, .most = 1e100};

template <class F>
Put intoStep(F place) {
  return into([place](Draft& d, std::size_t i) { return place(elementAt(d.forcing.steps, i)); });
}

template <class F>
Put intoForce(F place) {
  return into([place](Draft& d, std::size_t i) { return place(elementAt(d.forcing.forces, i)); });
}

std::vector<Key> gravityKeys() {
  return {
      {.path = "motion.gravity.mgr_body",
       .type = kVector,
       .dimension = kTorque,
       .range = kTorques,
       .example = "[0, 0, 2.84375]",
       .help = "Vector M g r in body axes. M g is the weight of the body, and r is the vector from the fixed "
               "point to the centre of mass. Gravity pulls along the world's -z. Without body.mass, the moments "
               "are about the fixed point. With mass and pivot, mgr_body must point from the pivot to the centre "
               "of mass, within 0.001 rad.",
       .put = into([](Draft& d) { return &d.forcing.mgr_B; })},
      {.path = "motion.gravity.g",
       .dimension = kAcceleration,
       .range = kPull,
       .example = "9.81",
       .help =
           "Acceleration of gravity, for a body that has a mass and a pivot. Use the key g instead of mgr_body.",
       .put = into([](Draft& d) { return &d.forcing.g; })},
  };
}

std::vector<Key> torqueKeys() {
  return {
      {.path = "motion.torque.body",
       .type = kVector,
       .dimension = kTorque,
       .range = kTorques,
       .example = "[0, 0, 0.01]",
       .help = "Constant torque in body axes.",
       .put = into([](Draft& d) { return &d.forcing.torque_B; })},
      {.path = "motion.torque.space",
       .type = kVector,
       .dimension = kTorque,
       .range = kTorques,
       .example = "[\"5 mN m\", 0, 0]",
       .help = "Constant torque in world axes.",
       .put = into([](Draft& d) { return &d.forcing.torque_W; })},
      {.path = "motion.torque.file",
       .type = kText,
       .range = kPathLength,
       .example = "\"torque.csv\"",
       .help = "CSV file that gives the torque over time. The file must be in the scene's folder or below it. "
               "Each line holds t,Nx,Ny,Nz: a time in s and three components in N m. The times must ascend. The "
               "first line may be the header t,Nx,Ny,Nz.",
       .put = into([](Draft& d) { return &d.forcing.torqueFile; })},
      {.path = "motion.torque.file_axes",
       .type = kWord,
       .words = {"body", "space"},
       .example = "\"space\"",
       .help = "Axes of the torque's components in the file. By default, these are the body's axes.",
       .put = into([](Draft& d) { return &d.forcing.fileAxes; })},
      {.path = "motion.torque.interpolation",
       .type = kWord,
       .words = {"linear", "steps"},
       .example = "\"steps\"",
       .help = "Interpolation of the torque between two lines of the CSV file. `linear`, the default, joins the "
               "two values by a straight line. `steps` keeps the earlier value until the time of the next line.",
       .put = into([](Draft& d) { return &d.forcing.interpolation; })},
  };
}

std::vector<Key> stepKeys() {
  return {
      {.path = "motion.torque.step[].from",
       .dimension = kTime,
       .range = kInstants,
       .example = "2.5",
       .help = "Motion time at which the torque of this step begins. The torque acts until the next step begins. "
               "Each step must begin later than the step before.",
       .put = intoStep([](TorqueStepDraft& s) { return &s.from; })},
      {.path = "motion.torque.step[].body",
       .type = kVector,
       .dimension = kTorque,
       .range = kTorques,
       .example = "[0, 0, 0.01]",
       .help = "Torque of this step in body axes. A torque of zero ends the torque of the step before.",
       .put = intoStep([](TorqueStepDraft& s) { return &s.torque_B; })},
      {.path = "motion.torque.step[].space",
       .type = kVector,
       .dimension = kTorque,
       .range = kTorques,
       .example = "[\"5 mN m\", 0, 0]",
       .help = "Torque of this step in world axes. A step can have `body`, `space` or both.",
       .put = intoStep([](TorqueStepDraft& s) { return &s.torque_W; })},
  };
}

std::vector<Key> forceKeys() {
  return {
      {.path = "motion.force[].at",
       .type = kVector,
       .dimension = kLength,
       .range = kPositions,
       .example = "[0.3, 0, \"-5 cm\"]",
       .help = "Point of the body at which the force acts, in the axes in which the body is described. The torque "
               "is that about body.pivot or, without a pivot, about the centre of mass. If the body has no mass, "
               "this reference point is the origin of the body's axes.",
       .put = intoForce([](PointForceDraft& f) { return &f.at_B; })},
      {.path = "motion.force[].space",
       .type = kVector,
       .dimension = kForce,
       .range = kForces,
       .example = "[0, \"2 kN\", 0]",
       .help = "Force that keeps its direction in space, in world axes. A force has `space` or `body`, not both.",
       .put = intoForce([](PointForceDraft& f) { return &f.force_W; })},
      {.path = "motion.force[].body",
       .type = kVector,
       .dimension = kForce,
       .range = kForces,
       .example = "[\"20 mN\", 0, 0]",
       .help = "Force that turns with the body, as that of a thruster does, in body axes.",
       .put = intoForce([](PointForceDraft& f) { return &f.force_B; })},
      {.path = "motion.force[].from",
       .dimension = kTime,
       .range = kInstants,
       .example = "-2.5",
       .help = "Motion time at which the force begins. By default, it acts from the beginning.",
       .put = intoForce([](PointForceDraft& f) { return &f.from; })},
      {.path = "motion.force[].to",
       .dimension = kTime,
       .range = kInstants,
       .example = "3.5",
       .help = "Motion time at which the force ends. By default, it never ends.",
       .put = intoForce([](PointForceDraft& f) { return &f.to; })},
      {.path = "motion.force[].name",
       .type = kText,
       .range = kForceName,
       .example = "'$\\mathbf{F}_a$'",
       .help = "Text at the arrow of the force. By default, it is F or, if there are several forces, F with the "
               "number of the force.",
       .isTex = true,
       .put = intoForce([](PointForceDraft& f) { return &f.name; })},
  };
}

std::vector<Key> lossKeys() {
  return {
      {.path = "motion.drag.rate",
       .type = kPerAxis,
       .dimension = kRate,
       .range = kRates,
       .example = "[0.01, 0.01, 0.05]",
       .help = "Rate d of a drag that slows the rotation, as in dL_i/dt = ... - d_i L_i. L_i are the components "
               "of L along the principal axes. One number sets d for all three axes.",
       .put = into([](Draft& d) { return &d.forcing.dragRates; })},
      {.path = "motion.dissipation.alpha",
       .dimension = kInverseAction,
       .range = kAlphas,
       .example = "0.02",
       .help = "Coefficient alpha of an energy loss inside the body that leaves L constant in space. In body "
               "axes, dL/dt = L x omega + alpha L x (L x omega). The attitude then turns at the rate omega + "
               "alpha L x omega instead of omega = I^-1 L. The command `trajectory` writes both rates.",
       .put = into([](Draft& d) { return &d.forcing.dissipation; })},
  };
}

std::vector<Key> flightKeys() {
  return {
      {.path = "motion.flight.position",
       .type = kVector,
       .dimension = kLength,
       .range = kPositions,
       .example = "[0, 0, 1.5]",
       .help =
           "Position of a thrown body's centre of mass, or of its `point`, at motion time 0, in world axes. The "
           "default is the origin.",
       .put = into([](Draft& d) { return &d.flight.position; })},
      {.path = "motion.flight.velocity",
       .type = kVector,
       .dimension = kVelocity,
       .range = kVelocities,
       .example = "[\"10 km/h\", 0, 4]",
       .help =
           "Velocity of a thrown body's centre of mass, or of its `point`, at motion time 0, in world axes. The "
           "default is 0.",
       .put = into([](Draft& d) { return &d.flight.velocity; })},
      {.path = "motion.flight.point",
       .type = kVector,
       .dimension = kLength,
       .range = kPositions,
       .example = "[0, 0, \"-20 cm\"]",
       .help =
           "Reference point K of the body, in body axes (eq 4 of docs/physics.md). `position` and `velocity` are "
           "then those of K instead of the centre of mass, and `info` prints each term of eq 4. The velocity "
           "is required. Unless the scene gives the attitude, the body's axes start along the world's axes.",
       .put = into([](Draft& d) { return &d.flight.point; })},
      {.path = "motion.flight.gravity",
       .type = kVector,
       .dimension = kAcceleration,
       .range = kAccelerations,
       .example = "[0, 0, -1.62]",
       .help = "Acceleration of free fall. By default, [0, 0, -9.80665].",
       .put = into([](Draft& d) { return &d.flight.gravity; })},
  };
}

std::vector<Key> rollingKeys() {
  return {
      {.path = "motion.rolling.rate",
       .dimension = kAngularVelocity,
       .range = kSpins,
       .example = "\"12 rpm\"",
       .help = "Rate at which the axis of a cone goes round the vertical, while the cone rolls on a level table "
               "without slipping. Its apex stays at one point of the table. A positive rate is counter-clockwise "
               "seen from above. The table gives the whole motion: the scene has no other start. The body is one "
               "shape \"cone\" or \"cone_shell\", with body.pivot at its apex.",
       .put = into([](Draft& d) { return &d.rolling.rate; })},
      {.path = "motion.rolling.g",
       .dimension = kAcceleration,
       .range = kPullOnTable,
       .fallback = "9.80665",
       .example = "1.62",
       .help = "Acceleration of gravity, which holds a rolling cone on its table. If the cone rolls too fast, it "
               "tips over the rim of its base, and the scene is refused.",
       .put = into([](Draft& d) { return &d.rolling.g; })},
  };
}

}  // namespace

std::vector<Key> forcingKeys() {
  return joined({gravityKeys(), torqueKeys(), stepKeys(), forceKeys(), lossKeys(), flightKeys(), rollingKeys()});
}

}  // namespace poinsot::scene
