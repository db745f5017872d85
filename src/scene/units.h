// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/abi.h"

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
  kRate,           ///< rate of decay, 1/s
  kInverseAction,  ///< rate of dissipation, s/(kg·m²)
};

/// Returns all dimensions except kNone, in the order of the reference.
std::span<const Dimension> dimensions();

/// Returns a name such as "an angular velocity"; "a number" for kNone.
std::string_view quantityName(Dimension dimension);

/// Returns a plural such as "angular velocities"; "numbers" for kNone.
std::string_view pluralName(Dimension dimension);

/// Returns the unit of a bare number, such as "rad/s"; empty for kNone.
std::string_view siUnit(Dimension dimension);

/// Returns units to suggest, the most usual first: "rad/s, deg/s, rpm, rev/s, Hz". Any other product of powers of
/// known units with the right dimension is accepted, too.
std::string_view usualUnits(Dimension dimension);

/// Returns usualUnits() for a message, with the command that lists all units.
std::string someUnits(Dimension dimension);

struct UnitText {
  std::string symbol;    ///< "m"
  std::string value;     ///< in SI units: "1 m", "0.0254 m"
  std::string prefixed;  ///< such as "km, cm, mm"; empty if the unit takes no prefix
  std::string also;      ///< other spellings: "inch, inches"; leaves out plurals of nouns in s
};

/// Returns the rules for spelling and combining units, as sentences for the user with code in backticks.
std::string_view unitRules();

/// Returns every unit that a product may contain, in the order of the table.
std::vector<UnitText> unitTexts();

/// Returns "4.4482216152605 N" for "lbf"; empty if the name is not a single unit.
std::string unitValue(std::string_view name);

/// Factor of a compound unit: a named unit to a power.
struct UnitTerm {
  std::string name;
  int power = 1;
  bool divides = false;  ///< divides by the power; a '/' precedes the name
};

/// Returns the factors of a unit in the order of the text; empty if the text is not a unit. "kg-m^2/s" yields kg,
/// m to the power 2, and the divisor s.
std::vector<UnitTerm> unitTerms(std::string_view unit);

/// Returns a regular expression (ECMA 262) for the units of a dimension as they are usually written.
/// parseQuantity() accepts everything that matches. Products that only cancel to the dimension (m^2/m) do not
/// match.
std::string unitPattern(Dimension dimension);

/// Parsed quantity, or the reason why the text is not valid.
struct Quantity {
  double value = std::numeric_limits<double>::quiet_NaN();  ///< in SI units; may be infinite or NaN
  std::string problem;  ///< empty if the text is valid; contains no untrusted bytes

  bool ok() const { return problem.empty(); }
};

/// Parses a number followed by a unit, independently of the locale: "15 deg", "1.5 kg m^2", "2.5e4 g·cm²", "3rpm",
/// "2 kg-m2".
/// Between two units, a blank, *, ·, ×, a point or a hyphen multiplies; ^2, **2, 2 and ² are powers. Names are
/// case-sensitive, because m and M are different prefixes. A unit may begin with a divisor: "2 /s" and "2 1/s"
/// mean "2 s^-1". A text without a unit is an error. For kNone the only unit is "%".
Quantity parseQuantity(std::string_view text, Dimension dimension);

/// Returns the value of one `unit` in SI units.
/// @pre the unit exists and has this dimension; "" is the SI unit.
double unitFactor(std::string_view unit, Dimension dimension);

}  // namespace poinsot::scene
