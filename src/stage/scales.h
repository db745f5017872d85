// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "stage/body/body_figure.h"
#include "stage/picture_motion.h"

namespace poinsot::stage {

/// How SI magnitudes become lengths in the picture, whose unit is about half of what is shown: body, ellipsoid
/// with plane, omega and L each have a scale of their own, so that a football and the Earth fill the frame alike.
struct Scales {
  double body = 1;       ///< per metre
  double ellipsoid = 1;  ///< per rad/s: ellipsoid, plane, polhode, herpolhode, contact point
  double flight = 1;     ///< per metre of the path of a thrown body
  double velocity = 1;   ///< per m/s: of the centre of mass and of points of the body
  double omega = 1;      ///< per rad/s: the arrow; the ellipsoid's unless the scene says otherwise
  double L = 1;          ///< per kg·m²/s: the arrow, of a fixed length where L is longest
  double reach =
      1;  ///< radius of the ball about the centre that holds the body, and the ellipsoid where it is shown
};

/// The part of the picture's height that captions may take.
inline constexpr double kMostStrip = 0.4;

Scales makeScales(const scene::Scene& scene, const PictureMotion& motion, const BodyFigure& body);

/// The pixels that a metre of the body has at most in each of several panels, for it to be as large in all of
/// them. Infinite where they can have too different ones: bodies that could differ by more than 1.6 in size are
/// not drawn alike, as the smaller would look lost. @pre there is one.
inline double commonMetre_px(std::span<const double> possible_px) {
  constexpr double kMostUnlike = 1.6;
  const auto [least, most] = std::ranges::minmax(possible_px);
  return most <= kMostUnlike * least ? least : std::numeric_limits<double>::infinity();
}

}  // namespace poinsot::stage
