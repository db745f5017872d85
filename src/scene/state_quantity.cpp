// SPDX-License-Identifier: Apache-2.0
#include "scene/state_quantity.h"

#include <cmath>
#include <limits>

#include "core/expect.h"
#include "physics/heavy_top.h"
#include "physics/level_attitude.h"
#include "physics/precession_cones.h"
#include "physics/reference_point.h"

namespace poinsot::scene {
namespace {

using Eigen::Vector3d;
using physics::RigidBodyState;
using Basis = QuantityBasis;

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

Vector3d spunAxis(const Vector3d& omega_P) {
  int axis = 2;
  if (!omega_P.isZero(0)) omega_P.cwiseAbs().maxCoeff(&axis);
  return (omega_P[axis] < 0 ? -1 : 1) * Vector3d::Unit(axis);
}

Vector3d figureAxis(const Basis& basis, const Vector3d& omega_P) {
  const Vector3d gravity_P = basis.axes().toP(basis.forcing().gravity_B);
  if (const auto top = physics::heavyTop(basis.axes().moments(), gravity_P)) return top->k_P;
  const auto cones = physics::precessionCones(basis.axes().moments(), omega_P);
  // For a sphere, every axis is an axis of symmetry. The spin axis is then a better choice than z.
  const bool symmetric = cones && cones->sense != physics::RollingSense::kNone;
  return symmetric ? cones->k_P : spunAxis(omega_P);
}

Vector3d nextAxis(const Vector3d& k_P) {
  int axis = 0;
  k_P.cwiseAbs().maxCoeff(&axis);
  return Vector3d::Unit((axis + 1) % 3);
}

Vector3d toW(const RigidBodyState& s, const Basis& b, const Vector3d& v_P) { return s.q_WB * b.axes().toB(v_P); }

Vector3d omega_P(const RigidBodyState& s, const Basis& b) { return b.axes().toP(s.omega_B); }
Vector3d L_P(const RigidBodyState& s, const Basis& b) { return b.axes().moments().angularMomentum(omega_P(s, b)); }

/// Returns the angle between two vectors. The result is also accurate for nearly parallel and nearly opposite
/// vectors. NaN if a vector is zero.
double angle(const Vector3d& a, const Vector3d& b) {
  if (a.isZero(0) || b.isZero(0)) return kMissing;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Axes x and y perpendicular to a pole. They are the world's x and y after the shortest rotation that takes z to
/// the pole. For a pole at -z, the shortest rotation is not unique. Within 1.4e-6 rad of -z, which covers rounding
/// errors of a pole that points down, a half turn about x is applied first, and then the shortest rotation from -z
/// to the pole.
struct Meridians {
  Vector3d x_W, y_W;
};

Meridians meridians(const Vector3d& pole_W) {
  const bool down = pole_W.z() < -1 + 1e-12;
  const auto turn = physics::turnOntoVertical(pole_W, down ? physics::Vertical::kDown : physics::Vertical::kUp);
  const Vector3d y = (down ? -1 : 1) * Vector3d::UnitY();
  return {turn.conjugate() * Vector3d::UnitX(), turn.conjugate() * y};
}

double size(const Vector3d& v) { return v.norm(); }

double omegaSize(const RigidBodyState& s, const Basis&) { return size(s.omega_W); }
double LSize(const RigidBodyState& s, const Basis&) { return size(s.L_W); }

/// Returns the quantities of the flight. If the body does not fly, they are 0, except L. If the mass of a flying
/// body is unknown, they are NaN.
physics::FlightQuantities flightOf(const RigidBodyState& s, const Basis& b) {
  static const ThrownBody still{.flight = physics::Flight{.gravity_W = Vector3d::Zero()}, .mass_kg = 0};
  const ThrownBody& thrown = b.thrown() ? *b.thrown() : still;
  return physics::flightQuantities(thrown.mass_kg, thrown.flight, b.forcing(), b.axes(), s);
}

template <int axis>
double position(const RigidBodyState& s, const Basis& b) {
  return b.thrown() ? b.thrown()->flight.positionAt(s.t_s)[axis] : kMissing;
}
template <int axis>
double velocity(const RigidBodyState& s, const Basis& b) {
  return b.thrown() ? b.thrown()->flight.velocityAt(s.t_s)[axis] : kMissing;
}
template <int axis>
double momentum(const RigidBodyState& s, const Basis& b) {
  return flightOf(s, b).P_W[axis];
}
double momentumSize(const RigidBodyState& s, const Basis& b) { return size(flightOf(s, b).P_W); }
template <int axis>
double orbitalL(const RigidBodyState& s, const Basis& b) {
  return flightOf(s, b).orbital_W[axis];
}
template <int axis>
double totalL(const RigidBodyState& s, const Basis& b) {
  return flightOf(s, b).total_W[axis];
}
double totalLSize(const RigidBodyState& s, const Basis& b) { return size(flightOf(s, b).orbital_W) + size(s.L_W); }

// ---- terms of the angular momentum about the origin, for a reference point K (eq 4)

/// Returns the terms at the time of the state. Without a point K, all are NaN.
physics::ReferencePointTerms termsOf(const RigidBodyState& s, const Basis& b) {
  if (!b.thrown() || !b.thrown()->point) {
    const Vector3d missing = Vector3d::Constant(kMissing);
    return {missing, missing, missing, missing, missing, missing, missing};
  }
  const auto& [flight, mass_kg, point] = *b.thrown();
  return physics::referencePointTerms(point->body, point->K_B,
                                      {flight.positionAt(s.t_s), flight.velocityAt(s.t_s), Vector3d::Zero()}, s);
}
template <Vector3d physics::ReferencePointTerms::*term, int axis>
double termOfK(const RigidBodyState& s, const Basis& b) {
  return (termsOf(s, b).*term)[axis];
}
double termsSize(const RigidBodyState& s, const Basis& b) {
  const physics::ReferencePointTerms terms = termsOf(s, b);
  return size(terms.translation_W) + size(terms.turningCentre_W) + size(terms.displaced_W) +
         size(terms.rotation_W);
}

// ---- energies; without the mass of the body, the energies of the flight are left out

double orZero(double value) { return std::isnan(value) ? 0 : value; }
double kineticEnergy(const RigidBodyState& s, const Basis&) { return s.kineticEnergy; }
double energyOfFlight(const RigidBodyState& s, const Basis& b) { return flightOf(s, b).translationalEnergy; }
double wholeKineticEnergy(const RigidBodyState& s, const Basis& b) { return flightOf(s, b).kineticEnergy(); }
double potentialEnergy(const RigidBodyState& s, const Basis& b) {
  return physics::potentialEnergy(b.forcing(), s.q_WB) + orZero(flightOf(s, b).potentialEnergy);
}
double energy(const RigidBodyState& s, const Basis& b) {
  return s.kineticEnergy + orZero(energyOfFlight(s, b)) + potentialEnergy(s, b);
}
double energySize(const RigidBodyState& s, const Basis& b) {
  const physics::FlightQuantities flight = flightOf(s, b);
  return s.kineticEnergy + size(b.forcing().gravity_B) + orZero(flight.translationalEnergy) +
         std::abs(orZero(flight.potentialEnergy));
}

template <int axis>
double omegaAlong(const RigidBodyState& s, const Basis& b) {
  return omega_P(s, b)[axis];
}
template <int axis>
double omegaInSpace(const RigidBodyState& s, const Basis&) {
  return s.omega_W[axis];
}
template <int axis>
double LAlong(const RigidBodyState& s, const Basis& b) {
  return L_P(s, b)[axis];
}
template <int axis>
double LInSpace(const RigidBodyState& s, const Basis&) {
  return s.L_W[axis];
}

double theta(const RigidBodyState& s, const Basis& b) { return angle(toW(s, b, b.k_P()), s.L_W); }
double thetaVertical(const RigidBodyState& s, const Basis& b) {
  return angle(toW(s, b, b.k_P()), Vector3d::UnitZ());
}
double omegaToL(const RigidBodyState& s, const Basis&) { return angle(s.omega_W, s.L_W); }

// Euler angles in the order z, x, z. The line of nodes is pole × k. If k is parallel to the pole, there is no line
// of nodes and the angle is missing.
double phi(const RigidBodyState& s, const Basis& b) {
  const Vector3d pole_W = b.pole_W(s), nodes_W = pole_W.cross(toW(s, b, b.k_P()));
  const Meridians m = meridians(pole_W);
  return nodes_W.isZero(0) ? kMissing : std::atan2(nodes_W.dot(m.y_W), nodes_W.dot(m.x_W));
}
double psi(const RigidBodyState& s, const Basis& b) {
  const Vector3d pole_W = b.pole_W(s);
  const double first = pole_W.dot(toW(s, b, b.across_P()));
  const double second = pole_W.dot(toW(s, b, b.k_P().cross(b.across_P())));
  return first == 0 && second == 0 ? kMissing : std::atan2(first, second);
}

// Angular rates in omega = phi' pole + psi' k + theta' n, where n is the line of nodes. For a free symmetric body,
// the first two terms are omega_p and -Omega_p k.
double phiRate(const RigidBodyState& s, const Basis& b) {
  const Vector3d pole_W = b.pole_W(s), k_W = toW(s, b, b.k_P());
  const double across = pole_W.cross(k_W).squaredNorm();
  return across == 0 ? kMissing : (pole_W.dot(s.omega_W) - pole_W.dot(k_W) * k_W.dot(s.omega_W)) / across;
}
double psiRate(const RigidBodyState& s, const Basis& b) {
  const Vector3d pole_W = b.pole_W(s), k_W = toW(s, b, b.k_P());
  const double across = pole_W.cross(k_W).squaredNorm();
  return across == 0 ? kMissing : (k_W.dot(s.omega_W) - pole_W.dot(k_W) * pole_W.dot(s.omega_W)) / across;
}

// Eq (29). In the lecture, omega_3 >= 0.
double bodyRate(const RigidBodyState& s, const Basis& b) {
  if (s.omega_B.isZero(0)) return 0;
  const auto cones = physics::precessionCones(b.axes().moments(), omega_P(s, b));
  return cones ? cones->bodyRate : kMissing;
}

double planeHeight(const RigidBodyState& s, const Basis&) {
  return s.L_W.isZero(0) ? kMissing : s.omega_W.dot(s.L_W.normalized());
}
double herpolhodeRadius(const RigidBodyState& s, const Basis&) {
  return s.L_W.isZero(0) ? kMissing : s.omega_W.cross(s.L_W.normalized()).norm();
}

double time(const RigidBodyState& s, const Basis&) { return s.t_s; }
double qw(const RigidBodyState& s, const Basis&) { return s.q_WB.w(); }
double qx(const RigidBodyState& s, const Basis&) { return s.q_WB.x(); }
double qy(const RigidBodyState& s, const Basis&) { return s.q_WB.y(); }
double qz(const RigidBodyState& s, const Basis&) { return s.q_WB.z(); }

using enum QuantityUnit;
using enum QuantityBranch;
using enum QuantityNeeds;
using F = QuantityFamily;
using Terms = physics::ReferencePointTerms;

constexpr StateQuantity kQuantities[] = {
    {"t", "t", "time of the motion", kSecond, F::kTime, kSmooth, time},
    {"omega_1", "\\omega_1", "omega along the first principal axis", kRadianPerSecond, F::kOmega, kSmooth,
     omegaAlong<0>, omegaSize},
    {"omega_2", "\\omega_2", "omega along the second principal axis", kRadianPerSecond, F::kOmega, kSmooth,
     omegaAlong<1>, omegaSize},
    {"omega_3", "\\omega_3", "omega along the third principal axis", kRadianPerSecond, F::kOmega, kSmooth,
     omegaAlong<2>, omegaSize},
    {"omega_x", "\\omega_x", "omega along the world's x axis", kRadianPerSecond, F::kOmega, kSmooth,
     omegaInSpace<0>, omegaSize},
    {"omega_y", "\\omega_y", "omega along the world's y axis", kRadianPerSecond, F::kOmega, kSmooth,
     omegaInSpace<1>, omegaSize},
    {"omega_z", "\\omega_z", "omega along the world's z axis", kRadianPerSecond, F::kOmega, kSmooth,
     omegaInSpace<2>, omegaSize},
    {"omega", "|\\boldsymbol{\\omega}|", "length of omega", kRadianPerSecond, F::kOmega, kSmooth, omegaSize,
     omegaSize},
    {"L_1", "L_1", "L along the first principal axis", kAction, F::kL, kSmooth, LAlong<0>, LSize},
    {"L_2", "L_2", "L along the second principal axis", kAction, F::kL, kSmooth, LAlong<1>, LSize},
    {"L_3", "L_3", "L along the third principal axis", kAction, F::kL, kSmooth, LAlong<2>, LSize},
    {"L_x", "L_x", "L along the world's x axis", kAction, F::kL, kSmooth, LInSpace<0>, LSize},
    {"L_y", "L_y", "L along the world's y axis", kAction, F::kL, kSmooth, LInSpace<1>, LSize},
    {"L_z", "L_z", "L along the world's z axis", kAction, F::kL, kSmooth, LInSpace<2>, LSize},
    {"L", "|\\mathbf{L}|", "length of L", kAction, F::kL, kSmooth, LSize, LSize},
    {"T", "T", "kinetic energy of the rotation", kJoule, F::kEnergy, kSmooth, kineticEnergy, energySize},
    {"V", "V",
     "potential energy, relative to the fixed point; for a thrown body with a mass, relative to the origin",
     kJoule, F::kEnergy, kSmooth, potentialEnergy, energySize},
    {"E", "E", "total energy: kinetic and potential", kJoule, F::kEnergy, kSmooth, energy, energySize},
    {"theta", "\\theta", "angle between k, the axis of symmetry or of the main spin, and L", kAngle, F::kBody,
     kSmooth, theta, nullptr, kNothing, "\\theta_L"},
    {"theta_vertical", "\\theta_z", "angle between k and the vertical; pictures under gravity call it theta",
     kAngle, F::kBody, kSmooth, thetaVertical, nullptr, kNothing, "\\theta"},
    {"theta_omega", "\\alpha", "angle between omega and L", kAngle, F::kOmega, kSmooth, omegaToL},
    {"phi", "\\varphi", "precession: angle of the line of nodes about L; under gravity, about the vertical",
     kAngle, F::kBody, kTurns, phi},
    {"psi", "\\psi", "spin: angle of the body about k from the line of nodes", kAngle, F::kBody, kTurns, psi},
    {"phi_rate", "\\dot{\\varphi}", "rate of the precession phi; for a free symmetric body, L/I1 (eq 34)",
     kRadianPerSecond, F::kOmega, kSmooth, phiRate, omegaSize},
    {"psi_rate", "\\dot{\\psi}", "rate of the spin psi; for a free symmetric body, -Omega_p (eq 29, 32)",
     kRadianPerSecond, F::kOmega, kSmooth, psiRate, omegaSize},
    {"Omega_p", "\\Omega_p",
     "rate at which omega goes round k on a free symmetric body, (I3/I1 - 1) omega_3 with omega_3 > 0 (eq 29)",
     kRadianPerSecond, F::kOmega, kSmooth, bodyRate, omegaSize, kFreeSymmetricBody},
    {"h", "h", "height of the centre above the point of contact, 2T/|L|", kRadianPerSecond, F::kL, kSmooth,
     planeHeight, omegaSize},
    {"rho", "\\rho", "distance of the point of contact from L: radius of the herpolhode", kRadianPerSecond,
     F::kOmega, kSmooth, herpolhodeRadius, omegaSize},
    {"q_w", "q_w", "scalar part of the attitude's quaternion", kBare, F::kBody, kSign, qw},
    {"q_x", "q_x", "x part of the attitude's quaternion", kBare, F::kBody, kSign, qx},
    {"q_y", "q_y", "y part of the attitude's quaternion", kBare, F::kBody, kSign, qy},
    {"q_z", "q_z", "z part of the attitude's quaternion", kBare, F::kBody, kSign, qz},
    {"R_x", "R_x", "position of the centre of mass of a thrown body along the world's x axis", kMetre, F::kFlight,
     kSmooth, position<0>, nullptr, kFlight},
    {"R_y", "R_y", "position of the centre of mass of a thrown body along the world's y axis", kMetre, F::kFlight,
     kSmooth, position<1>, nullptr, kFlight},
    {"R_z", "R_z", "position of the centre of mass of a thrown body along the world's z axis", kMetre, F::kFlight,
     kSmooth, position<2>, nullptr, kFlight},
    {"V_x", "V_x", "velocity of the centre of mass of a thrown body along x", kMetrePerSecond, F::kFlight, kSmooth,
     velocity<0>, nullptr, kFlight},
    {"V_y", "V_y", "velocity of the centre of mass of a thrown body along y", kMetrePerSecond, F::kFlight, kSmooth,
     velocity<1>, nullptr, kFlight},
    {"V_z", "V_z", "velocity of the centre of mass of a thrown body along z", kMetrePerSecond, F::kFlight, kSmooth,
     velocity<2>, nullptr, kFlight},
    {"P_x", "P_x", "momentum M V of a thrown body along x", kMomentum, F::kFlight, kSmooth, momentum<0>,
     momentumSize, kFlightAndMass},
    {"P_y", "P_y", "momentum M V of a thrown body along y", kMomentum, F::kFlight, kSmooth, momentum<1>,
     momentumSize, kFlightAndMass},
    {"P_z", "P_z", "momentum M V of a thrown body along z", kMomentum, F::kFlight, kSmooth, momentum<2>,
     momentumSize, kFlightAndMass},
    {"L_orbital_x", "(\\mathbf{R}\\times\\mathbf{P})_x",
     "orbital angular momentum R x P of a thrown body about the origin, along x", kAction, F::kL, kSmooth,
     orbitalL<0>, totalLSize, kFlightAndMass},
    {"L_orbital_y", "(\\mathbf{R}\\times\\mathbf{P})_y",
     "orbital angular momentum R x P of a thrown body about the origin, along y", kAction, F::kL, kSmooth,
     orbitalL<1>, totalLSize, kFlightAndMass},
    {"L_orbital_z", "(\\mathbf{R}\\times\\mathbf{P})_z",
     "orbital angular momentum R x P of a thrown body about the origin, along z", kAction, F::kL, kSmooth,
     orbitalL<2>, totalLSize, kFlightAndMass},
    {"L_total_x", "L_{\\mathrm{tot},x}",
     "total angular momentum R x P + L of a thrown body about the origin, along x", kAction, F::kL, kSmooth,
     totalL<0>, totalLSize, kFlightAndMass},
    {"L_total_y", "L_{\\mathrm{tot},y}",
     "total angular momentum R x P + L of a thrown body about the origin, along y", kAction, F::kL, kSmooth,
     totalL<1>, totalLSize, kFlightAndMass},
    {"L_total_z", "L_{\\mathrm{tot},z}",
     "total angular momentum R x P + L of a thrown body about the origin, along z", kAction, F::kL, kSmooth,
     totalL<2>, totalLSize, kFlightAndMass},
    {"L_K_translation_x", "(\\mathbf{R}\\times M\\mathbf{V})_x", "R x M V of the point K, a term of eq 4, along x",
     kAction, F::kL, kSmooth, termOfK<&Terms::translation_W, 0>, termsSize, kFlightByPoint},
    {"L_K_translation_y", "(\\mathbf{R}\\times M\\mathbf{V})_y", "R x M V of the point K, a term of eq 4, along y",
     kAction, F::kL, kSmooth, termOfK<&Terms::translation_W, 1>, termsSize, kFlightByPoint},
    {"L_K_translation_z", "(\\mathbf{R}\\times M\\mathbf{V})_z", "R x M V of the point K, a term of eq 4, along z",
     kAction, F::kL, kSmooth, termOfK<&Terms::translation_W, 2>, termsSize, kFlightByPoint},
    {"L_K_mixed_1_x", "(\\mathbf{R}\\times M\\dot{\\mathbf{c}})_x",
     "R x (omega x M c) of the point K, a term of eq 4, along x", kAction, F::kL, kSmooth,
     termOfK<&Terms::turningCentre_W, 0>, termsSize, kFlightByPoint},
    {"L_K_mixed_1_y", "(\\mathbf{R}\\times M\\dot{\\mathbf{c}})_y",
     "R x (omega x M c) of the point K, a term of eq 4, along y", kAction, F::kL, kSmooth,
     termOfK<&Terms::turningCentre_W, 1>, termsSize, kFlightByPoint},
    {"L_K_mixed_1_z", "(\\mathbf{R}\\times M\\dot{\\mathbf{c}})_z",
     "R x (omega x M c) of the point K, a term of eq 4, along z", kAction, F::kL, kSmooth,
     termOfK<&Terms::turningCentre_W, 2>, termsSize, kFlightByPoint},
    {"L_K_mixed_2_x", "(M\\mathbf{c}\\times\\mathbf{V})_x", "M c x V of the point K, a term of eq 4, along x",
     kAction, F::kL, kSmooth, termOfK<&Terms::displaced_W, 0>, termsSize, kFlightByPoint},
    {"L_K_mixed_2_y", "(M\\mathbf{c}\\times\\mathbf{V})_y", "M c x V of the point K, a term of eq 4, along y",
     kAction, F::kL, kSmooth, termOfK<&Terms::displaced_W, 1>, termsSize, kFlightByPoint},
    {"L_K_mixed_2_z", "(M\\mathbf{c}\\times\\mathbf{V})_z", "M c x V of the point K, a term of eq 4, along z",
     kAction, F::kL, kSmooth, termOfK<&Terms::displaced_W, 2>, termsSize, kFlightByPoint},
    {"L_K_rotation_x", "(I_K\\boldsymbol{\\omega})_x", "I_K omega of the point K, a term of eq 4, along x",
     kAction, F::kL, kSmooth, termOfK<&Terms::rotation_W, 0>, termsSize, kFlightByPoint},
    {"L_K_rotation_y", "(I_K\\boldsymbol{\\omega})_y", "I_K omega of the point K, a term of eq 4, along y",
     kAction, F::kL, kSmooth, termOfK<&Terms::rotation_W, 1>, termsSize, kFlightByPoint},
    {"L_K_rotation_z", "(I_K\\boldsymbol{\\omega})_z", "I_K omega of the point K, a term of eq 4, along z",
     kAction, F::kL, kSmooth, termOfK<&Terms::rotation_W, 2>, termsSize, kFlightByPoint},
    {"T_cm", "T_\\mathrm{cm}", "kinetic energy of the centre of mass of a thrown body, M V^2/2", kJoule,
     F::kEnergy, kSmooth, energyOfFlight, energySize, kFlightAndMass},
    {"T_total", "T_\\mathrm{tot}", "total kinetic energy of a thrown body, T_cm + T", kJoule, F::kEnergy, kSmooth,
     wholeKineticEnergy, energySize, kFlightAndMass},
};

}  // namespace

QuantityBasis::QuantityBasis(const physics::PrincipalAxes& axes, const physics::Forcing& forcing,
                             const Vector3d& startOmega_P, std::optional<ThrownBody> thrown)
    : axes_(axes),
      forcing_(forcing),
      thrown_(std::move(thrown)),
      k_P_(figureAxis(*this, startOmega_P)),
      across_P_(nextAxis(k_P_)) {}

Vector3d QuantityBasis::pole_W(const RigidBodyState& state) const {
  if (!forcing_.gravity_B.isZero(0) || state.L_W.isZero(0)) return Vector3d::UnitZ();
  return state.L_W.normalized();
}

void QuantityBasis::follow(const physics::Motion& motion) {
  if (thrown_) thrown_->flight = {thrown_->flight.gravityAlone(), thrown_->mass_kg, motion};
}

Dimension dimensionOf(QuantityUnit unit) {
  switch (unit) {
    case kSecond:
      return Dimension::kTime;
    case kMetre:
      return Dimension::kLength;
    case kMetrePerSecond:
      return Dimension::kVelocity;
    case kRadianPerSecond:
      return Dimension::kAngularVelocity;
    case kMomentum:
      return Dimension::kMomentum;
    case kAction:
      return Dimension::kAngularMomentum;
    case kJoule:
      return Dimension::kEnergy;
    case kAngle:
      return Dimension::kAngle;
    case kBare:
      break;
  }
  return Dimension::kNone;
}

std::string_view unitText(QuantityUnit unit) {
  switch (unit) {
    case kSecond:
      return "a time";
    case kMetre:
      return "a length";
    case kMetrePerSecond:
      return "in m/s";
    case kRadianPerSecond:
      return "in rad/s";
    case kMomentum:
      return "in kg·m/s";
    case kAction:
      return "in kg·m²/s";
    case kJoule:
      return "in J";
    case kAngle:
      return "an angle";
    case kBare:
      break;
  }
  return "a bare number";
}

std::span<const StateQuantity> stateQuantities() { return kQuantities; }

const StateQuantity& stateQuantity(int index) {
  POINSOT_EXPECT(index >= 0 && index < static_cast<int>(std::size(kQuantities)));
  return kQuantities[index];
}

std::string quantityTex(int index, const physics::Forcing& forcing) {
  const StateQuantity& quantity = stateQuantity(index);
  const bool hasOther = !forcing.gravity_B.isZero(0) && !quantity.texUnderGravity.empty();
  return std::string(hasOther ? quantity.texUnderGravity : quantity.tex);
}

}  // namespace poinsot::scene
