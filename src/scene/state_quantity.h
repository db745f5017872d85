// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/abi.h"
#include "physics/flight_path.h"
#include "physics/forcing.h"
#include "physics/mass_properties.h"
#include "physics/principal_axes.h"
#include "physics/rigid_body_state.h"
#include "scene/units.h"

namespace poinsot::scene {

/// Point K by which a body is thrown (eq 4), in B, m, and the masses of this body.
struct ThrownPoint {
  physics::MassProperties body;
  Eigen::Vector3d K_B;
};

/// Flight of a thrown body, and its mass. Without a mass (NaN), momentum and energy of the flight are NaN. Without
/// a point K, so are the terms of eq (4).
struct ThrownBody {
  physics::FlightPath flight;
  double mass_kg = std::numeric_limits<double>::quiet_NaN();
  std::optional<ThrownPoint> point = {};
};

/// Body, forcing and body axis k, from which the quantities of a state are computed. The axis k is:
/// - for a top under gravity whose centre of mass lies on a principal axis: this axis, towards the centre of mass;
/// - for any other symmetric body: the axis of symmetry (lecture, eq 19 to 37);
/// - for any other body: the principal axis with the largest component of omega at the start.
/// Without gravity, the sense of k is that of omega at the start. For a cone on a table, k points to its base.
class QuantityBasis {
 public:
  /// @param thrown  flight of a thrown body; nullopt for other bodies
  QuantityBasis(const physics::PrincipalAxes& axes, const physics::Forcing& forcing,
                const Eigen::Vector3d& startOmega_P, std::optional<ThrownBody> thrown = {});

  const physics::PrincipalAxes& axes() const { return axes_; }
  const physics::Forcing& forcing() const { return forcing_; }
  const std::optional<ThrownBody>& thrown() const { return thrown_; }
  /// Sets the motion whose states the basis is used for. Forces at points of a thrown body make its flight depend
  /// on the motion. Has no effect for other bodies.
  void follow(const physics::Motion& motion);

  /// Unit vectors in P: the third Euler axis k of the body, and its first Euler axis, perpendicular to k.
  const Eigen::Vector3d& k_P() const { return k_P_; }
  const Eigen::Vector3d& across_P() const { return across_P_; }

  /// Returns the unit vector about which the angle phi is counted. This is the direction of L. If gravity acts or
  /// L is 0, it is the upward vertical.
  Eigen::Vector3d pole_W(const physics::RigidBodyState& state) const;

 private:
  physics::PrincipalAxes axes_;
  physics::Forcing forcing_;
  std::optional<ThrownBody> thrown_;
  Eigen::Vector3d k_P_, across_P_;
};

/// Group of quantities that have the same colour.
enum class QuantityFamily { kTime, kOmega, kL, kEnergy, kBody, kFlight };

/// Jump of a quantity between neighbouring states: none, 2 pi of an angle, or the sign of a quaternion.
enum class QuantityBranch { kSmooth, kTurns, kSign };

enum class QuantityUnit {
  kSecond,
  kMetre,
  kMetrePerSecond,
  kRadianPerSecond,
  kMomentum,
  kAction,
  kJoule,
  kAngle,
  kBare
};

/// Requirement of a quantity on the scene.
enum class QuantityNeeds { kNothing, kFlight, kFlightAndMass, kFlightByPoint, kFreeSymmetricBody };

struct StateQuantity {
  std::string_view name;  ///< name in a scene, such as "omega_1"
  std::string_view tex;   ///< TeX symbol without dollar signs, such as "\omega_1"
  std::string_view help;
  QuantityUnit unit;
  QuantityFamily family;
  QuantityBranch branch = QuantityBranch::kSmooth;
  /// Returns the value in SI units and radians. NaN if the value does not exist, such as an angle to L at rest.
  double (*value)(const physics::RigidBodyState&, const QuantityBasis&);
  /// Returns a scale for rounding errors of the value, such as |omega| for omega_1. Null if the scale is 1.
  double (*size)(const physics::RigidBodyState&, const QuantityBasis&) = nullptr;
  QuantityNeeds needs = QuantityNeeds::kNothing;
  std::string_view texUnderGravity = {};  ///< TeX symbol if gravity acts; empty if it is `tex`
};

Dimension dimensionOf(QuantityUnit unit);

/// Describes a unit for messages and the reference, such as "in rad/s" or "an angle".
std::string_view unitText(QuantityUnit unit);

/// Returns all quantities in the order of the reference. Scenes store indices into this list.
std::span<const StateQuantity> stateQuantities();

/// Returns the quantity with this index in stateQuantities().
/// @pre index of a quantity.
const StateQuantity& stateQuantity(int index);

/// Returns the TeX symbol of a quantity in a picture. The symbol depends on the forcing: if gravity acts, angles
/// are counted from the vertical, so theta is the angle to the vertical.
/// @pre index of a quantity.
std::string quantityTex(int index, const physics::Forcing& forcing);

static_assert(core::laidOut<ThrownBody, 232>());
static_assert(core::laidOut<ThrownPoint, 128>());

}  // namespace poinsot::scene
