// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "figure/visibility.h"

namespace poinsot::figure {

/// Point of a curve in the picture. `depth` is the distance along the view minus the curve's lift.
struct PiecePoint {
  glm::dvec2 p_px{0};
  double depth = 0;
};

struct Piece {
  std::vector<PiecePoint> points;
  bool closed = false;
  double width_px = 1;
  draw::Color color{0};
};

/// Returns the visible pieces of a flat curve, cut where solids hide it and where sheets change its colour.
std::vector<Piece> visiblePieces(const Visibility& visibility, const draw::Camera& camera,
                                 const draw::Curve& curve);

/// Sorts pieces for painting: where two of different colour meet, the farther one comes first. Cuts pieces that
/// are over one another in one place and under in another.
std::vector<Piece> inPaintingOrder(const std::vector<Piece>& pieces);

}  // namespace poinsot::figure
