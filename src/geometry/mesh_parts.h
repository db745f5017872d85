// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "geometry/mesh.h"

// Internal to this layer.
namespace poinsot::geometry {

/// A volume this small beside that of its bounding box is rounding: of a surface folded onto itself.
inline constexpr double kNoVolume = 1e-14;

/// Finds a part of a closed mesh that is inside out and lies in no other part, so that it is no cavity: its volume
/// would count as less than nothing. Parts are what common vertices join; "lies in" compares bounding boxes, so
/// that a true cavity is never taken for such a part.
/// @returns one of its triangles, or nothing. Also nothing for a mesh of so many parts that comparing them would
/// take longer than reading it.
/// @pre as many triangles run one way along each edge as the other; indices in range, coordinates finite.
std::optional<std::size_t> strayCavity(const Mesh& mesh);

}  // namespace poinsot::geometry
