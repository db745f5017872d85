// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"
#include "scene/state_quantity.h"

namespace poinsot::stage {

struct WrittenUnit {
  double perSi = 1;    ///< written number = perSi times the number in SI
  int powerOfTen = 0;  ///< exponent of the factor before the unit; perSi contains that factor
  std::string tex;     ///< unit, upright, for a formula; empty for a bare number

  double written(double si) const { return si * perSi; }
};

/// Returns a unit in which numbers up to `largest` (SI) need few digits: degrees; for times, µs to years;
/// otherwise the SI unit. Numbers outside 0.01 to 10 000 get a power of a thousand before the unit.
WrittenUnit writtenUnit(scene::QuantityUnit unit, double largest);

/// Returns the unit `asked`, or a suitable one if `asked` is empty. @pre `asked` is empty or a unit of the same
/// dimension.
WrittenUnit writtenUnit(scene::QuantityUnit unit, double largest, const std::string& asked);

/// Returns "kg m^2" as \mathrm{kg\,m^2}: upright, with the space of a product. "deg" becomes the degree sign.
std::string unitInFormula(const std::string& unit);

/// Returns an axis's label, the quotient of quantity and unit (ISO 80000-1, 7.1):
/// "$\omega_1\,/\,(\mathrm{rad/s})$".
/// @param tex  symbol of the quantity, for a formula
std::string axisLabel(std::string_view tex, const WrittenUnit& unit);

/// Returns the unit as written after a number: "$\,\mathrm{s}$", with the power of ten; empty for a bare number.
std::string unitSuffix(const WrittenUnit& unit);

/// Returns a formula of decimal digits ("-0.15"), in which all digits are of one width.
std::string numberTex(std::string_view digits, scene::DecimalSign sign);

/// Returns the decimals that distinguish a few hundred values over a range of that length, a pixel or two of a
/// plot.
int decimalsThatResolve(double length);

/// Returns the digits of x with so many decimals, never "-0.00". Returns "--" if x is not finite.
std::string fixedDigits(double x, int decimals);

}  // namespace poinsot::stage
