// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <numbers>
#include <string_view>

#include "scene/units.h"

/// The units and the dimensions that units.h knows.
namespace poinsot::scene {

// Exponents of length, mass, time and angle. The angle is a dimension here, so that "3 Hz" is a rotation rate and
// "1 rad" never passes for a plain number.
using Exponents = std::array<int, 4>;

struct Unit {
  double factor = 1;
  Exponents exponents{};
};

struct NamedUnit {
  std::string_view name;
  Unit unit;
};

inline constexpr Exponents kPlain{0, 0, 0, 0}, kL{1, 0, 0, 0}, kM{0, 1, 0, 0}, kT{0, 0, 1, 0}, kA{0, 0, 0, 1},
    kSpin{0, 0, -1, 1}, kForce{1, 1, -2, 0}, kWork{2, 1, -2, 0};
inline constexpr double kTurn = 2 * std::numbers::pi;

// Inch, foot, pound and ounce are exact by definition (1959); a day is 24 h and a year 365.25 days (IAU).
inline constexpr NamedUnit kUnits[] = {
    {"%", {0.01, kPlain}},
    {"m", {1, kL}},
    {"km", {1e3, kL}},
    {"cm", {1e-2, kL}},
    {"mm", {1e-3, kL}},
    {"um", {1e-6, kL}},
    {"µm", {1e-6, kL}},
    {"in", {0.0254, kL}},
    {"ft", {0.3048, kL}},
    {"kg", {1, kM}},
    {"g", {1e-3, kM}},
    {"mg", {1e-6, kM}},
    {"t", {1e3, kM}},
    {"lb", {0.45359237, kM}},
    {"oz", {0.028349523125, kM}},
    {"s", {1, kT}},
    {"ms", {1e-3, kT}},
    {"us", {1e-6, kT}},
    {"µs", {1e-6, kT}},
    {"min", {60, kT}},
    {"h", {3600, kT}},
    {"d", {86400, kT}},
    {"yr", {365.25 * 86400, kT}},
    {"rad", {1, kA}},
    {"mrad", {1e-3, kA}},
    {"deg", {std::numbers::pi / 180, kA}},
    {"°", {std::numbers::pi / 180, kA}},
    {"arcmin", {std::numbers::pi / 10800, kA}},
    {"arcsec", {std::numbers::pi / 648000, kA}},
    {"rev", {kTurn, kA}},
    {"Hz", {kTurn, kSpin}},
    {"rpm", {kTurn / 60, kSpin}},
    {"N", {1, kForce}},
    {"mN", {1e-3, kForce}},
    {"kN", {1e3, kForce}},
    {"J", {1, kWork}},
    {"mJ", {1e-3, kWork}},
    {"kJ", {1e3, kWork}},
    // In full, as people write them, too.
    {"meter", {1, kL}},
    {"meters", {1, kL}},
    {"metre", {1, kL}},
    {"metres", {1, kL}},
    {"inch", {0.0254, kL}},
    {"inches", {0.0254, kL}},
    {"foot", {0.3048, kL}},
    {"feet", {0.3048, kL}},
    {"kilogram", {1, kM}},
    {"kilograms", {1, kM}},
    {"pound", {0.45359237, kM}},
    {"pounds", {0.45359237, kM}},
    {"lbs", {0.45359237, kM}},
    {"gram", {1e-3, kM}},
    {"grams", {1e-3, kM}},
    {"second", {1, kT}},
    {"seconds", {1, kT}},
    {"sec", {1, kT}},
    {"minute", {60, kT}},
    {"minutes", {60, kT}},
    {"hour", {3600, kT}},
    {"hours", {3600, kT}},
    {"day", {86400, kT}},
    {"days", {86400, kT}},
    {"year", {365.25 * 86400, kT}},
    {"years", {365.25 * 86400, kT}},
    {"degree", {std::numbers::pi / 180, kA}},
    {"degrees", {std::numbers::pi / 180, kA}},
    {"radian", {1, kA}},
    {"radians", {1, kA}},
    {"turn", {kTurn, kA}},
    {"turns", {kTurn, kA}},
    {"rps", {kTurn, kSpin}},
};

struct DimensionText {
  Exponents exponents;
  std::string_view name, plural, si, usual;
};

// Indexed by Dimension.
inline constexpr DimensionText kDimensions[] = {
    {kPlain, "a number", "numbers", "", "%"},
    {kL, "a length", "lengths", "m", "m, km, cm, mm, um, in, ft"},
    {kM, "a mass", "masses", "kg", "kg, g, mg, t, lb, oz"},
    {kT, "a time", "times", "s", "s, ms, us, min, h, d, yr"},
    {kA, "an angle", "angles", "rad", "rad, mrad, deg, arcmin, arcsec, rev"},
    {kSpin, "an angular velocity", "angular velocities", "rad/s", "rad/s, deg/s, rpm, rev/s, rev/d, Hz"},
    {{2, 1, 0, 0}, "a moment of inertia", "moments of inertia", "kg·m²", "kg m^2, g cm^2"},
    {{-3, 1, 0, 0}, "a density", "densities", "kg/m³", "kg/m^3, g/cm^3"},
    {{1, 0, -1, 0}, "a velocity", "velocities", "m/s", "m/s, cm/s, km/h, ft/s"},
    {{1, 0, -2, 0}, "an acceleration", "accelerations", "m/s²", "m/s^2, cm/s^2, ft/s^2"},
    {kWork, "a torque", "torques", "N·m", "N m, mN m, N cm, kN m"},
    {kWork, "an energy", "energies", "J", "J, mJ, kJ, N m"},
    {{2, 1, -1, 0}, "an angular momentum", "angular momenta", "kg·m²/s", "kg m^2/s, g cm^2/s, N m s, J s"},
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
                                     Dimension::kTorque,
                                     Dimension::kEnergy,
                                     Dimension::kAngularMomentum,
                                     Dimension::kRate,
                                     Dimension::kInverseAction};

inline const DimensionText& textOf(Dimension dimension) {
  return kDimensions[static_cast<std::size_t>(dimension)];
}

}  // namespace poinsot::scene
