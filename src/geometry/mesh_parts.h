// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "geometry/mesh.h"

namespace poinsot::geometry {

/// Volume, relative to the bounding box, below which only rounding is left: the surface is folded onto itself.
inline constexpr double kNoVolume = 1e-14;

/// Finds a part of a closed mesh that is inside out and lies in no other part. Such a part is no cavity, and its
/// volume would count as negative. A part is joined by common vertices. Whether it lies in another is decided by
/// bounding boxes, so that a true cavity is never reported.
/// @returns a triangle of the part, or nullopt. Also nullopt for a mesh of so many parts that comparing them would
/// take longer than reading it.
/// @pre as many triangles run one way along each edge as the other; indices in range, coordinates finite.
std::optional<std::size_t> strayCavity(const Mesh& mesh);

}  // namespace poinsot::geometry
