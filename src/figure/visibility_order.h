// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "figure/visibility_pieces.h"

namespace poinsot::figure {

/// The pieces in an order to be painted in: wherever two of different colour meet, the farther one first. Pieces
/// that are over one another in one place and under in another are cut.
std::vector<Piece> inPaintingOrder(const std::vector<Piece>& pieces);

}  // namespace poinsot::figure
