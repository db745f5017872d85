// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "draw/visibility_solids.h"

namespace poinsot::draw {

/// Null for a flat curve (radius_W = 0) and for one with fewer than two points.
std::unique_ptr<const Occluder> makeTubeOccluder(const Camera& camera, const Curve& curve);

}  // namespace poinsot::draw
