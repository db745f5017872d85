// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/abi.h"
#include "physics/precession_cones.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Published numbers of the Earth. None of them is fitted to the observed period of the wobble.
namespace earth {

inline constexpr double kGravitation = 6.67428e-11;       ///< G, m³/(kg·s²); IERS Conventions (2010), table 1.1
inline constexpr double kGM = 3.986004418e14;             ///< m³/s²; same table
inline constexpr double kEquatorialRadius_m = 6378136.6;  ///< same table
inline constexpr double kInverseFlattening = 298.25642;   ///< same table
inline constexpr double kDynamicalFlattening = .003273795;  ///< H = (C - A)/C; same table
inline constexpr double kPolarMoment = 8.0365e37;           ///< C, kg·m²; E. Groten, J. Geodesy 77 (2004) 724
inline constexpr double kSpin = 7.292115e-5;                ///< nominal rate, rad/s; IERS Conventions (2010)

/// Love number k of an elastic Earth with a fluid core and without oceans, computed from the seismic model PREM;
/// J. M. Wahr, Geophys. J. R. astr. Soc. 64 (1981) 677 and J. Geophys. Res. 90 (1985) 9363.
inline constexpr double kLoveNumber = .298;
/// A_m/A: share of the mantle and crust in the equatorial moment, from PREM; P. M. Mathews, B. A. Buffett, T. A.
/// Herring, I. I. Shapiro, J. Geophys. Res. 96 (1991) 8219. The test integrates PREM and finds the same share.
inline constexpr double kMantleShare = 7.0999 / 8.0115;

/// Observed period of the wobble, solar days, and its error; C. R. Wilson, R. O. Vicente, AGU Geophys. Monogr. 59
/// (1990) 151.
inline constexpr double kObserved_days = 433.0, kObservedError_days = 1.1;

}  // namespace earth

/// Periods of the Earth's wobble by three models, s.
struct EarthWobble {
  double secularLoveNumber = 0;  ///< k_s = 3 G (C - A)/(Omega² a⁵)
  double rigid_s = 0;            ///< eq 29: 2 pi/Omega_p
  double elastic_s = 0;          ///< rigid_s/(1 - k/k_s)
  double fluidCore_s = 0;        ///< elastic_s A_m/A
};

/// Returns whether a top resembles the Earth: (C - A)/A within 2 % and the spin within 1 %. The unit of the
/// moments does not matter. Rigid models of the Earth differ by 1 % in (C - A)/A (0.0033 and 1/306). One turn a
/// solar day and one turn a sidereal day differ by 0.3 %.
bool resemblesEarth(const PrecessionCones& cones);

/// Returns the periods of the wobble, or nullopt if the body is not the Earth: resemblesEarth() must hold, and C
/// must be within 1 % of the Earth's.
///
/// The elastic Earth yields to the centrifugal force of its own rotation. A fluid Earth (k = k_s) would turn its
/// bulge along with omega and not wobble at all. An Earth with the Love number k lets the part k/k_s of its bulge
/// follow omega, and only the rest turns omega about k (A. E. H. Love, Proc. R. Soc. A 82 (1909) 73; W. H. Munk,
/// G. J. F. MacDonald, The Rotation of the Earth, 1960). The fluid core does not take part, so that the same
/// torque turns the moment A_m of the mantle only: 2 pi/T = Omega (A/A_m)(e - kappa), with e = (C - A)/A and kappa
/// = e k/k_s (T. Sasao, S. Okubo, M. Saito, IAU Symp. 78 (1980) 165; Mathews et al. 1991). The model has no oceans
/// and no anelastic mantle.
/// @param moments in kg·m²
std::optional<EarthWobble> earthWobble(const PrincipalMoments& moments, const PrecessionCones& cones);

static_assert(core::laidOut<EarthWobble, 32>());

}  // namespace poinsot::physics
