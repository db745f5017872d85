// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "figure/visibility_solids.h"

namespace poinsot::figure {

/// Null for a flat curve (radius_W = 0) and for one with fewer than two points.
std::unique_ptr<const Occluder> makeTubeOccluder(const draw::Camera& camera, const draw::Curve& curve);

}  // namespace poinsot::figure
