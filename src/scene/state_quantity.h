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

namespace poinsot::scene {

/// Body in flight. Without a mass, momentum and energy of the flight are undefined (NaN).
struct ThrownBody {
  physics::Flight flight;
  double mass_kg = std::numeric_limits<double>::quiet_NaN();
};

/// Reference for the quantities of a state: the body, its forcing and its axis k.
///
/// For a top under gravity whose centre of mass lies on a principal axis, k is that axis and points to the centre
/// of mass. For any other symmetric body, k is the axis of symmetry (lecture, eq 19 to 37). For the rest, k is the
/// principal axis with the largest component of omega at the start. Without gravity k points along the start's
/// omega.
class QuantityBasis {
 public:
  /// @param thrown  nullopt if the body does not fly
  QuantityBasis(const physics::PrincipalAxes& axes, const physics::Forcing& forcing,
                const Eigen::Vector3d& startOmega_P, std::optional<ThrownBody> thrown = {});

  const physics::PrincipalAxes& axes() const { return axes_; }
  const physics::Forcing& forcing() const { return forcing_; }
  const std::optional<ThrownBody>& thrown() const { return thrown_; }

  /// Third Euler axis of the body (k), and the first, which is perpendicular to k. Unit vectors in P.
  const Eigen::Vector3d& k_P() const { return k_P_; }
  const Eigen::Vector3d& across_P() const { return across_P_; }

  /// Returns the unit direction about which phi is counted: that of L, or the upward vertical if gravity acts or L
  /// is 0.
  Eigen::Vector3d pole_W(const physics::RigidBodyState& state) const;

 private:
  physics::PrincipalAxes axes_;
  physics::Forcing forcing_;
  std::optional<ThrownBody> thrown_;
  Eigen::Vector3d k_P_, across_P_;
};

/// Group of quantities with a common colour.
enum class QuantityFamily { kTime, kOmega, kL, kEnergy, kBody, kFlight };

/// Kind of discontinuity between neighbouring states: angles jump by 2 pi, and the sign of a quaternion is free.
enum class QuantityBranch { kSmooth, kTurns, kSign };

enum class QuantityUnit { kSecond, kMetre, kMetrePerSecond, kRadianPerSecond, kAction, kJoule, kAngle, kBare };

/// Requirement of a quantity, besides a motion.
enum class QuantityNeeds { kNothing, kFlight, kFlightAndMass };

struct StateQuantity {
  std::string_view name;  ///< as written in a scene: "omega_1"
  std::string_view tex;   ///< without dollar signs: "\omega_1"
  std::string_view help;
  QuantityUnit unit;
  QuantityFamily family;
  QuantityBranch branch = QuantityBranch::kSmooth;
  /// Returns the value in SI units and radians; NaN if it does not exist (an angle to L at rest).
  double (*value)(const physics::RigidBodyState&, const QuantityBasis&);
  /// Returns the magnitude to which the value's rounding is relative, such as |omega| for omega_1. Null: 1.
  double (*size)(const physics::RigidBodyState&, const QuantityBasis&) = nullptr;
  QuantityNeeds needs = QuantityNeeds::kNothing;
  std::string_view texUnderGravity = {};  ///< replaces `tex` if gravity acts; empty: `tex`
};

Dimension dimensionOf(QuantityUnit unit);

/// Describes a unit for messages and the reference: "in rad/s", "an angle".
std::string_view unitText(QuantityUnit unit);

/// Returns all quantities in the order of the reference. Scenes store indices into this list.
std::span<const StateQuantity> stateQuantities();

/// Returns a quantity by its index in stateQuantities().
/// @pre index of a quantity.
const StateQuantity& stateQuantity(int index);

/// Returns the TeX symbol of a quantity in pictures of a body with this forcing. If gravity acts, angles are
/// counted from the vertical, so theta means the angle to the vertical.
/// @pre index of a quantity.
std::string quantityTex(int index, const physics::Forcing& forcing);

static_assert(core::laidOut<ThrownBody, 80>());

}  // namespace poinsot::scene
