// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "figure/visibility.h"

namespace poinsot::figure {

/// A point of a curve in the picture; the depth is what the curve is sorted by, its lift taken off.
struct PiecePoint {
  glm::dvec2 p_px{0};
  double depth = 0;
};

/// A stretch of a curve that is seen in one colour.
struct Piece {
  std::vector<PiecePoint> points;
  bool closed = false;
  double width_px = 1;
  draw::Color color{0};
};

/// Cuts a flat curve where solids hide it and where its colour changes behind sheets.
std::vector<Piece> visiblePieces(const Visibility& visibility, const draw::Camera& camera,
                                 const draw::Curve& curve);

/// The pieces in an order to be painted in: wherever two of different colour meet, the farther one first. Pieces
/// that are over one another in one place and under in another are cut.
std::vector<Piece> inPaintingOrder(const std::vector<Piece>& pieces);

}  // namespace poinsot::figure
