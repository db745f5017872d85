// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"
#include "scene/state_quantity.h"

namespace poinsot::stage {

struct WrittenUnit {
  double perSi = 1;    ///< written number = perSi times the number in SI
  int powerOfTen = 0;  ///< exponent of the power of ten before the unit; perSi contains this factor
  std::string tex;     ///< unit as upright TeX inside a formula; empty for a bare number

  double written(double si) const { return si * perSi; }
};

/// Returns a unit in which numbers up to `largest` (SI) need few digits. Angles are in degrees, times in µs to
/// years, and other quantities in their SI unit. Numbers outside 0.01 to 10 000 get a power of a thousand before
/// the unit.
WrittenUnit writtenUnit(scene::QuantityUnit unit, double largest);

/// Returns the unit `asked`, or a suitable one if `asked` is empty. @pre `asked` is empty or a unit of the same
/// dimension.
WrittenUnit writtenUnit(scene::QuantityUnit unit, double largest, const std::string& asked);

/// Converts a unit to TeX inside a formula: "kg m^2" becomes \mathrm{kg\,m^2}, and "deg" becomes the degree sign.
std::string unitInFormula(const std::string& unit);

/// Returns an axis's label, the quotient of quantity and unit (ISO 80000-1, 7.1):
/// "$\omega_1\,/\,(\mathrm{rad/s})$".
/// @param tex  symbol of the quantity, for a formula
std::string axisLabel(std::string_view tex, const WrittenUnit& unit);

/// Returns the unit to write after a number, such as "$\,\mathrm{s}$", with the power of ten; empty for a bare
/// number.
std::string unitSuffix(const WrittenUnit& unit);

/// Returns decimal digits, such as "-0.15", as a formula in which all digits have the same width.
std::string numberTex(std::string_view digits, scene::DecimalSign sign);

/// Returns decimal digits for use inside a formula.
std::string digitsInFormula(std::string_view digits, scene::DecimalSign sign);

/// Returns the number of decimals that distinguishes a few hundred values in a range of this length. In a plot,
/// these values are a pixel or two apart.
int decimalsThatResolve(double length);

/// Returns `x` with this number of decimals, never "-0.00". Returns "--" if `x` is not finite.
std::string fixedDigits(double x, int decimals);

}  // namespace poinsot::stage
