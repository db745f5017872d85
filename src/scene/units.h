// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

/// Quantities written as text ("3 rpm", "20 cm") and their value in SI units.
namespace poinsot::scene {

enum class Dimension {
  kNone,
  kLength,
  kMass,
  kTime,
  kAngle,
  kAngularVelocity,
  kMomentOfInertia,
  kDensity,
  kVelocity,
  kAcceleration,
  kTorque,
  kEnergy,
  kAngularMomentum,
  kRate,           ///< 1/s, of decay
  kInverseAction,  ///< s/(kg·m²), of dissipation
};

/// All of them but kNone, in the order of the reference.
std::span<const Dimension> dimensions();

/// "an angular velocity"; "a number" for kNone.
std::string_view quantityName(Dimension dimension);

/// "angular velocities"; "numbers" for kNone.
std::string_view pluralName(Dimension dimension);

/// The unit of a bare number: "rad/s"; empty for kNone.
std::string_view siUnit(Dimension dimension);

/// Units to offer, the most usual first: "rad/s, deg/s, rpm, rev/s, Hz". Any product of powers of known units with
/// the right dimension is accepted besides.
std::string_view usualUnits(Dimension dimension);

/// A regular expression (ECMA 262) for the units of a dimension as they are usually written. What it matches
/// parseQuantity() reads; products that only cancel to the dimension (m^2/m) it leaves out.
std::string unitPattern(Dimension dimension);

/// A quantity read, or why it could not be.
struct Quantity {
  double value = std::numeric_limits<double>::quiet_NaN();  ///< SI; may be infinite or NaN when the text says so
  std::string problem;  ///< empty when all is well; contains no untrusted bytes

  bool ok() const { return problem.empty(); }
};

/// Reads a number followed by a unit, whatever the locale: "15 deg", "1.5 kg m^2", "2.5e4 g·cm²", "3rpm".
/// A unit may begin with the divisor: "2 /s" and "2 1/s" are "2 s^-1".
/// A text without a unit is refused, except for kNone, where the only unit is "%".
Quantity parseQuantity(std::string_view text, Dimension dimension);

/// Value of one `unit` in SI. @pre the unit exists and has this dimension; "" is the SI unit.
double unitFactor(std::string_view unit, Dimension dimension);

}  // namespace poinsot::scene
