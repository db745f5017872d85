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

/// What the frame must hold: points, and a ball about the centre (radius 0: none).
struct Extent {
  std::vector<Eigen::Vector3d> points_V;
  double ballRadius = 0;
};

/// A camera in the scene's direction, as near as it can be with all of `extent` inside the margins. It depends on
/// the whole motion and not on the time: nothing breathes.
draw::Camera frameAll(const scene::Camera& camera, const Extent& extent, const Margins& margins,
                      glm::vec2 size_px);

}  // namespace poinsot::stage
