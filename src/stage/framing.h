// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "draw/camera.h"
#include "scene/scene.h"

namespace poinsot::stage {

/// Free border of the picture, as shares of its height (top, bottom) and width (left, right).
struct Margins {
  double left = 0.06, right = 0.06, top = 0.06, bottom = 0.06;
};

/// A camera in the scene's direction, as near as it can be with all `points_V` inside the margins. It is made once
/// for the whole film, from points that hold the whole motion: nothing breathes.
draw::Camera frameAll(const scene::Camera& camera, const std::vector<Eigen::Vector3d>& points_V,
                      const Margins& margins, glm::vec2 size_px);

}  // namespace poinsot::stage
