// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "figure/visibility.h"

namespace poinsot::figure {

/// Point of a curve in the picture. `depth` is its distance along the view minus the curve's lift_V.
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

/// Returns the visible pieces of a flat curve. It is cut where solids hide it and where sheets change its colour.
std::vector<Piece> visiblePieces(const Visibility& visibility, const draw::Camera& camera,
                                 const draw::Curve& curve);

/// Sorts pieces for painting: where pieces of different colour meet, the farther piece comes first. Pieces that
/// lie over each other at one point and under at another are cut.
std::vector<Piece> inPaintingOrder(const std::vector<Piece>& pieces);

}  // namespace poinsot::figure
