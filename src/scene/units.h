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

/// usualUnits() for a message, with the command that lists the whole table of units.
std::string someUnits(Dimension dimension);

/// One unit of the table, for lists.
struct UnitText {
  std::string symbol;    ///< "m"
  std::string value;     ///< in SI units: "1 m", "0.0254 m"
  std::string prefixed;  ///< "km, cm, mm"; empty where no prefix is read
  std::string also;      ///< other spellings: "inch, inches"; a noun's plural in s is left out
};

/// How names of units are spelled and combined, in sentences for the user; code stands in backticks.
std::string_view unitRules();

/// Every unit that a product may contain, in the order of the table.
std::vector<UnitText> unitTexts();

/// "4.4482216152605 N" for "lbf"; empty for a name that is no single unit.
std::string unitValue(std::string_view name);

/// One factor of a unit: name to the power, or divided by that.
struct UnitTerm {
  std::string name;
  int power = 1;
  bool divides = false;  ///< a '/' stands before it
};

/// The factors of a unit in the order of the text, empty where it is no unit: "kg-m^2/s" is kg, m to the 2, by s.
std::vector<UnitTerm> unitTerms(std::string_view unit);

/// A regular expression (ECMA 262) for the units of a dimension as they are usually written. What it matches
/// parseQuantity() reads; products that only cancel to the dimension (m^2/m) it leaves out.
std::string unitPattern(Dimension dimension);

/// A quantity read, or why it could not be.
struct Quantity {
  double value = std::numeric_limits<double>::quiet_NaN();  ///< SI; may be infinite or NaN when the text says so
  std::string problem;  ///< empty when all is well; contains no untrusted bytes

  bool ok() const { return problem.empty(); }
};

/// Reads a number followed by a unit, whatever the locale: "15 deg", "1.5 kg m^2", "2.5e4 g·cm²", "3rpm", "2
/// kg-m2". Between two units, a blank, *, ·, ×, a point or a hyphen multiplies; ^2, **2, 2 and ² are powers. Names
/// are case-sensitive, because m and M are different prefixes. A unit may begin with the divisor: "2 /s" and "2
/// 1/s" are "2 s^-1". A text without a unit is refused, except for kNone, where the only unit is "%".
Quantity parseQuantity(std::string_view text, Dimension dimension);

/// Value of one `unit` in SI. @pre the unit exists and has this dimension; "" is the SI unit.
double unitFactor(std::string_view unit, Dimension dimension);

}  // namespace poinsot::scene
