// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/abi.h"

/// Quantities as text with a unit, such as "3 rpm" or "20 cm", and their values in SI units.
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
  kForce,
  kTorque,
  kEnergy,
  kMomentum,
  kAngularMomentum,
  kRate,           ///< decay rate, 1/s
  kInverseAction,  ///< coefficient of dissipation, s/(kg·m²)
};

/// Returns all dimensions except kNone, in the order of the reference.
std::span<const Dimension> dimensions();

/// Returns the name of a dimension, such as "an angular velocity". For kNone, "a number".
std::string_view quantityName(Dimension dimension);

/// Returns the plural of a dimension's name, such as "angular velocities". For kNone, "numbers".
std::string_view pluralName(Dimension dimension);

/// Returns the SI unit of a dimension, such as "rad/s". Numbers without a unit have this unit. Empty for kNone.
std::string_view siUnit(Dimension dimension);

/// Returns units to suggest, the most usual first, such as "rad/s, deg/s, rpm, rev/s, Hz". parseQuantity() also
/// accepts every other product of powers of known units with the same dimension.
std::string_view usualUnits(Dimension dimension);

/// Returns usualUnits() for a message, followed by the command that lists all units.
std::string someUnits(Dimension dimension);

struct UnitText {
  std::string symbol;    ///< name such as "m"
  std::string value;     ///< value in SI units, such as "0.0254 m"
  std::string prefixed;  ///< symbols with a prefix, such as "km, cm, mm"; may be empty
  std::string also;      ///< other spellings, such as "inch, inches"; without plurals that only add an s
};

/// Returns the rules for spelling and combining units, as sentences with code in backticks.
std::string_view unitRules();

/// Returns all units that a product may contain, in the order of the table.
std::vector<UnitText> unitTexts();

/// Returns a unit's value in SI units, such as "4.4482216152605 N" for "lbf"; empty for anything but one unit.
std::string unitValue(std::string_view name);

/// Factor of a compound unit: the power of a named unit.
struct UnitTerm {
  std::string name;
  int power = 1;
  bool divides = false;  ///< whether the compound unit is divided by this power, because '/' precedes the name
};

/// Returns the factors of a unit in the order of the text. "kg-m^2/s" yields kg, m to the power 2, and the divisor
/// s. Empty if the text is not a unit.
std::vector<UnitTerm> unitTerms(std::string_view unit);

/// Returns a regular expression (ECMA 262) for the usual spellings of the units of a dimension. parseQuantity()
/// accepts every unit that matches, and more. For example, m^2/m is a length but does not match.
std::string unitPattern(Dimension dimension);

/// Parsed quantity, or what is wrong with the text.
struct Quantity {
  double value = std::numeric_limits<double>::quiet_NaN();  ///< value in SI units; may be infinite or NaN
  std::string problem;  ///< empty if the text is valid; contains no untrusted bytes

  bool ok() const { return problem.empty(); }
};

/// Parses a number with a unit, independently of the locale: "15 deg", "1.5 kg m^2", "2.5e4 g·cm²", "2 kg-m2",
/// "3rpm". A text without a unit is an error. For kNone, the only unit is "%".
/// Multiplication signs are blank, *, ·, ×, point and hyphen. Powers are written ^2, **2, 2 or ². Names are
/// case-sensitive, because m and M are different prefixes. A unit may begin with a divisor: "2 /s" and "2 1/s"
/// mean "2 s^-1".
Quantity parseQuantity(std::string_view text, Dimension dimension);

/// Returns the value of one `unit` in SI units.
/// @pre the unit exists and has this dimension; "" is the SI unit.
double unitFactor(std::string_view unit, Dimension dimension);

}  // namespace poinsot::scene
