// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/abi.h"
#include "physics/flight.h"
#include "physics/forcing.h"
#include "physics/principal_axes.h"
#include "physics/rigid_body_state.h"
#include "scene/units.h"

/// The named scalars of a motion: what plots and read-outs show.
namespace poinsot::scene {

/// A body in flight; of one without a mass, no momentum and no energy of the flight exists.
struct ThrownBody {
  physics::Flight flight;
  double mass_kg = std::numeric_limits<double>::quiet_NaN();
};

/// What a state's quantities are measured against: the body, what acts on it, and its axis k. Of a symmetric body
/// k is the axis of symmetry (lecture, eq 19 to 37), of a top under gravity whose centre of mass lies on a
/// principal axis that axis, of any other body the principal axis with the largest part of omega at the start.
/// Without gravity it points along the start's omega, of such a top to the centre of mass.
class QuantityBasis {
 public:
  /// `thrown`: none where the body does not fly.
  QuantityBasis(const physics::PrincipalAxes& axes, const physics::Forcing& forcing,
                const Eigen::Vector3d& startOmega_P, std::optional<ThrownBody> thrown = {});

  const physics::PrincipalAxes& axes() const { return axes_; }
  const physics::Forcing& forcing() const { return forcing_; }
  const std::optional<ThrownBody>& thrown() const { return thrown_; }

  /// Third Euler axis of the body, and the first, across it; in P, unit.
  const Eigen::Vector3d& k_P() const { return k_P_; }
  const Eigen::Vector3d& across_P() const { return across_P_; }

  /// The direction about which phi is counted: L's, or the upward vertical where gravity acts. Unit; of a body
  /// without angular momentum the vertical.
  Eigen::Vector3d pole_W(const physics::RigidBodyState& state) const;

 private:
  physics::PrincipalAxes axes_;
  physics::Forcing forcing_;
  std::optional<ThrownBody> thrown_;
  Eigen::Vector3d k_P_, across_P_;
};

/// Which meaning a quantity's colour has.
enum class QuantityFamily { kTime, kOmega, kL, kEnergy, kBody, kFlight };

/// What the values of neighbouring states have in common, where they are not continuous: angles jump by 2 pi, the
/// sign of a quaternion is free.
enum class QuantityBranch { kSmooth, kTurns, kSign };

enum class QuantityUnit { kSecond, kMetre, kMetrePerSecond, kRadianPerSecond, kAction, kJoule, kAngle, kBare };

/// What a quantity cannot do without, besides a motion.
enum class QuantityNeeds { kNothing, kFlight, kFlightAndMass };

struct StateQuantity {
  std::string_view name;  ///< in a scene: "omega_1"
  std::string_view tex;   ///< without dollar signs: "\omega_1"
  std::string_view help;
  QuantityUnit unit;
  QuantityFamily family;
  QuantityBranch branch = QuantityBranch::kSmooth;
  /// In SI and radians; NaN where it does not exist (an angle to L at rest).
  double (*value)(const physics::RigidBodyState&, const QuantityBasis&);
  /// What the value's rounding is a small part of: |omega| for omega_1; null: 1.
  double (*size)(const physics::RigidBodyState&, const QuantityBasis&) = nullptr;
  QuantityNeeds needs = QuantityNeeds::kNothing;
  std::string_view texUnderGravity = {};  ///< empty: as ever
};

/// Of a unit that one may ask for: kNone for a bare number.
Dimension dimensionOf(QuantityUnit unit);

/// For messages and the reference: "in rad/s", "an angle".
std::string_view unitText(QuantityUnit unit);

/// All of them, in the order of the reference. An index into it is what a scene keeps.
std::span<const StateQuantity> stateQuantities();

/// @pre index of a quantity.
const StateQuantity& stateQuantity(int index);

/// What pictures of a body with that forcing call it: angles are counted from the vertical where gravity acts, so
/// theta is the one to the vertical there.
/// @pre index of a quantity.
std::string quantityTex(int index, const physics::Forcing& forcing);

static_assert(core::laidOut<ThrownBody, 80>());

}  // namespace poinsot::scene
