// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "stage/body/body_figure.h"
#include "stage/picture_motion.h"

namespace poinsot::stage {

/// Scales from SI quantities to lengths in the picture. A picture length of 1 is about half the size of the
/// drawing. The body, the ellipsoid, omega and L have separate scales, so that a football and the Earth fill the
/// picture equally.
struct Scales {
  double body = 1;       ///< scale of the body, in picture lengths per metre
  double ellipsoid = 1;  ///< scale of the ellipsoid, plane, polhode and herpolhode, in picture lengths per rad/s
  double flight = 1;     ///< scale of a thrown body's path, in picture lengths per metre
  double velocity = 1;   ///< scale of velocity arrows, in picture lengths per m/s
  double omega = 1;      ///< scale of the arrow omega, per rad/s; equals `ellipsoid` unless the scene changes it
  double L = 1;          ///< scale of the arrow L, per kg·m²/s; gives the largest L of the film a fixed length
  /// Radius of a ball about the centre that contains the body, and also the ellipsoid if it is shown.
  double reach = 1;
};

/// Largest height of the strip for captions, as a fraction of the picture's height.
inline constexpr double kMostStrip = 0.4;

Scales makeScales(const scene::Scene& scene, const PictureMotion& motion, const BodyFigure& body);

/// Returns one scale of the body that fits several panels, in pixels per metre. Returns infinity if the largest
/// scales of the panels differ by more than a factor of 1.6, because the smaller body would then look lost.
/// @param possible_px  largest scale of each panel. @pre not empty.
inline double commonMetre_px(std::span<const double> possible_px) {
  constexpr double kMostUnlike = 1.6;
  const auto [least, most] = std::ranges::minmax(possible_px);
  return most <= kMostUnlike * least ? least : std::numeric_limits<double>::infinity();
}

}  // namespace poinsot::stage
