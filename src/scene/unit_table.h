// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <numbers>
#include <string_view>

#include "scene/units.h"

/// Table of all units and dimensions, for the parser, the JSON schema, `poinsot explain units` and docs/scene.md.
namespace poinsot::scene {

// Exponents of length, mass, time and angle. Angle counts as a dimension. Therefore "3 Hz" is an angular velocity,
// and "1 rad" is not a plain number.
using Exponents = std::array<int, 4>;

struct Unit {
  double factor = 1;
  Exponents exponents{};
};

/// SI prefix. `symbols` lists its spellings, separated by blanks. The first spelling has one letter, by which
/// UnitRow::prefixes names the prefix.
struct Prefix {
  std::string_view symbols, name;
  double factor;
};

// The prefix micro is written u, with the micro sign (U+00B5), or with the Greek letter (U+03BC).
inline constexpr Prefix kPrefixes[] = {
    {"T", "tera", 1e12}, {"G", "giga", 1e9},   {"M", "mega", 1e6},   {"k", "kilo", 1e3},
    {"d", "deci", 1e-1}, {"c", "centi", 1e-2}, {"m", "milli", 1e-3}, {"u µ μ", "micro", 1e-6},
    {"n", "nano", 1e-9}, {"p", "pico", 1e-12},
};

/// Unit with all its spellings. Blanks separate the spellings.
struct UnitRow {
  std::string_view symbols;  ///< the first symbol is the one printed, and the one that can have a prefix
  std::string_view nouns;    ///< may have a final s, and the name of a prefix
  Unit unit;
  std::string_view prefixes{};  ///< first letters of the prefixes that the unit can have
};

inline constexpr Exponents kPlain{0, 0, 0, 0}, kL{1, 0, 0, 0}, kM{0, 1, 0, 0}, kT{0, 0, 1, 0}, kA{0, 0, 0, 1},
    kSpin{0, 0, -1, 1}, kForce{1, 1, -2, 0}, kWork{2, 1, -2, 0}, kMoment{2, 1, 0, 0}, kSpeed{1, 0, -1, 0},
    kImpulse{1, 1, -1, 0}, kAction{2, 1, -1, 0};
inline constexpr double kTurn = 2 * std::numbers::pi, kDegree = std::numbers::pi / 180;

// Values of units:
// - Inch, foot, yard, mile, pound and ounce are exact (international agreement of 1959).
// - A nautical mile is 1852 m (1929), a day 24 h, a year 365.25 days (IAU).
// - A pound-force is exactly 1 lb times g_n = 9.80665 m/s² (CGPM 1901).
// - A slug is 1 lbf s²/ft = 4.4482216152605/0.3048 kg.
// - An ångström is 1e-10 m.
// - u is the atomic mass constant of CODATA 2022, 1.660 539 068 92(52)e-27 kg.
// The table does not contain ton, mil, gr and kt, because each has two meanings. It does not contain the
// megametre, because Mm is usually a misspelling of mm.
inline constexpr UnitRow kUnits[] = {
    {"%", "", {0.01, kPlain}},
    {"m", "metre meter", {1, kL}, "kdcmunp"},
    {"Å Å", "angstrom", {1e-10, kL}},
    {"in inch inches", "", {0.0254, kL}},
    {"ft foot feet", "", {0.3048, kL}},
    {"yd", "yard", {0.9144, kL}},
    {"mi", "mile", {1609.344, kL}},
    {"nmi", "", {1852, kL}},
    {"g gm", "gram", {1e-3, kM}, "Mkmu"},
    {"t", "tonne", {1e3, kM}},
    {"lb lbs lbm", "pound", {0.45359237, kM}},
    {"oz", "ounce", {0.028349523125, kM}},
    {"slug slugs", "", {14.593902937206364829, kM}},
    {"u amu", "", {1.66053906892e-27, kM}},
    {"Da", "dalton", {1.66053906892e-27, kM}, "k"},
    {"s sec", "second", {1, kT}, "munp"},
    {"min mins", "minute", {60, kT}},
    {"h hr hrs", "hour", {3600, kT}},
    {"d", "day", {86400, kT}},
    {"yr", "year", {365.25 * 86400, kT}},
    {"rad", "radian", {1, kA}, "mun"},
    {"deg °", "degree", {kDegree, kA}, "m"},
    {"arcmin", "arcminute", {std::numbers::pi / 10800, kA}},
    {"arcsec", "arcsecond", {std::numbers::pi / 648000, kA}},
    {"mas", "", {std::numbers::pi / 648e6, kA}},
    {"rev revs", "revolution turn cycle", {kTurn, kA}},
    {"Hz", "hertz", {kTurn, kSpin}, "TGMkm"},
    {"rpm RPM", "", {kTurn / 60, kSpin}, "k"},
    {"rps", "", {kTurn, kSpin}},
    {"dps", "", {kDegree, kSpin}},
    {"N", "newton", {1, kForce}, "Mkmun"},
    {"lbf", "", {4.4482216152605, kForce}},
    {"ozf", "", {0.27801385095378125, kForce}},
    {"kgf", "", {9.80665, kForce}},
    {"gf", "", {0.00980665, kForce}},
    {"dyn", "dyne", {1e-5, kForce}},
    {"J", "joule", {1, kWork}, "GMkmun"},
    {"Nm", "", {1, kWork}, "Mkmun"},
    {"Ncm", "", {1e-2, kWork}},
    {"erg ergs", "", {1e-7, kWork}},
    {"Nms", "", {1, kAction}, "kmu"},
    {"mph", "", {0.44704, kSpeed}},
    {"kph", "", {1 / 3.6, kSpeed}},
    {"kn", "knot", {1852 / 3600., kSpeed}},
};

struct DimensionText {
  Exponents exponents;
  std::string_view name, plural, si, usual;
};

// The index is a Dimension.
inline constexpr DimensionText kDimensions[] = {
    {kPlain, "a number", "numbers", "", "%"},
    {kL, "a length", "lengths", "m", "m, km, cm, mm, um, in, ft, Å"},
    {kM, "a mass", "masses", "kg", "kg, g, mg, t, lb, oz, slug, u"},
    {kT, "a time", "times", "s", "s, ms, us, min, h, d, yr"},
    {kA, "an angle", "angles", "rad", "rad, mrad, deg, arcmin, arcsec, rev"},
    {kSpin, "an angular velocity", "angular velocities", "rad/s",
     "rad/s, deg/s, deg/h, rpm, rev/s, rev/d, Hz, kHz"},
    {kMoment, "a moment of inertia", "moments of inertia", "kg·m²",
     "kg m^2, g cm^2, g mm^2, lb ft^2, lb in^2, oz in^2, slug ft^2, lbf in s^2, u Å^2"},
    {{-3, 1, 0, 0}, "a density", "densities", "kg/m³", "kg/m^3, g/cm^3, lb/ft^3, lb/in^3"},
    {kSpeed, "a velocity", "velocities", "m/s", "m/s, cm/s, km/h, ft/s, mph, kn"},
    {{1, 0, -2, 0}, "an acceleration", "accelerations", "m/s²", "m/s^2, cm/s^2, ft/s^2"},
    {kForce, "a force", "forces", "N", "N, mN, kN, lbf, ozf, kgf, dyn"},
    {kWork, "a torque", "torques", "N·m", "N m, mN m, N cm, kN m, lbf ft, lbf in, ozf in"},
    {kWork, "an energy", "energies", "J", "J, mJ, kJ, N m, ft lbf"},
    {kImpulse, "a momentum", "momenta", "kg·m/s", "kg m/s, g cm/s, N s, lb ft/s, lbf s"},
    {kAction, "an angular momentum", "angular momenta", "kg·m²/s",
     "kg m^2/s, g cm^2/s, N m s, J s, slug ft^2/s, lbf ft s"},
    {{0, 0, -1, 0}, "a rate", "rates", "1/s", "1/s, 1/min, 1/h, 1/d, 1/yr"},
    {{-2, -1, 1, 0}, "an inverse angular momentum", "inverse angular momenta", "s/(kg·m²)", "s/kg/m^2"},
};

inline constexpr Dimension kAll[] = {Dimension::kLength,
                                     Dimension::kMass,
                                     Dimension::kTime,
                                     Dimension::kAngle,
                                     Dimension::kAngularVelocity,
                                     Dimension::kMomentOfInertia,
                                     Dimension::kDensity,
                                     Dimension::kVelocity,
                                     Dimension::kAcceleration,
                                     Dimension::kForce,
                                     Dimension::kTorque,
                                     Dimension::kEnergy,
                                     Dimension::kMomentum,
                                     Dimension::kAngularMomentum,
                                     Dimension::kRate,
                                     Dimension::kInverseAction};

inline const DimensionText& textOf(Dimension dimension) {
  return kDimensions[static_cast<std::size_t>(dimension)];
}

}  // namespace poinsot::scene
