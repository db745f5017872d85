// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "stage/body/body_figure.h"
#include "stage/picture_motion.h"

namespace poinsot::stage {

/// Scales from SI magnitudes to lengths in the picture, whose unit is about half of what is shown. The body, the
/// ellipsoid with its plane, omega and L have separate scales, so that a football and the Earth fill the frame
/// alike.
struct Scales {
  double body = 1;       ///< picture lengths per metre of the body
  double ellipsoid = 1;  ///< picture lengths per rad/s: ellipsoid, plane, polhode, herpolhode, contact point
  double flight = 1;     ///< picture lengths per metre of a thrown body's path
  double velocity = 1;   ///< picture lengths per m/s: velocities of the centre of mass and of body points
  double omega = 1;      ///< picture lengths per rad/s: the arrow; equals `ellipsoid` unless scaled by the scene
  double L = 1;          ///< picture lengths per kg·m²/s: the arrow, whose longest length in the film is fixed
  /// Radius of the ball about the centre that holds the body, and the ellipsoid if it is shown.
  double reach = 1;
};

/// Largest share of the picture's height for captions.
inline constexpr double kMostStrip = 0.4;

Scales makeScales(const scene::Scene& scene, const PictureMotion& motion, const BodyFigure& body);

/// Returns a common scale of the body in several panels, in pixels per metre. Returns infinity if the panels'
/// largest scales differ by more than a factor of 1.6, because at one scale the smaller body would look lost.
/// @param possible_px  largest scale of each panel. @pre not empty.
inline double commonMetre_px(std::span<const double> possible_px) {
  constexpr double kMostUnlike = 1.6;
  const auto [least, most] = std::ranges::minmax(possible_px);
  return most <= kMostUnlike * least ? least : std::numeric_limits<double>::infinity();
}

}  // namespace poinsot::stage
