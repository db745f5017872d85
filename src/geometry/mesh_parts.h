// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "geometry/mesh.h"

namespace poinsot::geometry {

/// Volume that counts as 0, as a fraction of the bounding box. A surface that is folded onto itself has such a
/// volume, which consists only of rounding errors.
inline constexpr double kNoVolume = 1e-14;

/// Finds a part of a closed mesh that is inside out and does not lie in another part. Such a part is not a cavity,
/// and its volume would count as negative. Triangles with common vertices belong to the same part. Bounding boxes
/// decide whether a part lies in another, so that a true cavity is never reported.
/// @returns the index of a triangle of the part, or nullopt if there is no such part. Also returns nullopt if the
/// mesh has so many parts that comparing them would take longer than reading the file.
/// @pre as many triangles run one way along each edge as the other; indices in range, coordinates finite.
std::optional<std::size_t> strayCavity(const Mesh& mesh);

}  // namespace poinsot::geometry
