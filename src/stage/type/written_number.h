// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"
#include "scene/state_quantity.h"

/// Numbers and units as they are set in plots and read-outs.
namespace poinsot::stage {

/// The unit that numbers are written in.
struct WrittenUnit {
  double perSi = 1;    ///< written number = perSi times the one in SI
  int powerOfTen = 0;  ///< written before the unit, and in perSi
  std::string tex;     ///< roman, in a formula; empty for a bare number

  double written(double si) const { return si * perSi; }
};

/// A unit in which numbers up to `largest` (SI, as all that is small in it counts) need few digits: degrees; of
/// time s to years; else a power of a thousand before the SI unit, where 0.01 to 10 000 do not do.
WrittenUnit writtenUnit(scene::QuantityUnit unit, double largest);

/// The same in the unit that was asked for, where one was. @pre `asked` is empty or a unit of these.
WrittenUnit writtenUnit(scene::QuantityUnit unit, double largest, const std::string& asked);

/// "kg m^2" as \mathrm{kg\,m^2}: upright, with the space that a product has. "deg" is the degree sign.
std::string unitInFormula(const std::string& unit);

/// "$\omega_1\,/\,(\mathrm{rad/s})$": the quotient of quantity and unit (ISO 80000-1, 7.1), for an axis.
/// `tex` stands in a formula.
std::string axisLabel(std::string_view tex, const WrittenUnit& unit);

/// After a number: "$\,\mathrm{s}$", with the power of ten; empty for a bare number.
std::string unitSuffix(const WrittenUnit& unit);

/// A formula of decimal digits ("-0.15"), in which all digits are of one width.
std::string numberTex(std::string_view digits, scene::DecimalSign sign);

/// So many decimals as tell a few hundred values apart over a range of that length, a pixel or two of a plot.
int decimalsThatResolve(double length);

/// The digits of x with so many decimals; never "-0.00". "--" for what is no number.
std::string fixedDigits(double x, int decimals);

}  // namespace poinsot::stage
