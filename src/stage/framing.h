// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "draw/camera.h"
#include "scene/scene.h"

namespace poinsot::stage {

/// Free border of the picture, as shares of its height (top, bottom) and width (left, right).
struct Margins {
  bool operator==(const Margins&) const = default;

  double left = 0.06, right = 0.06, top = 0.06, bottom = 0.06;
};

/// What the frame must hold: points, and a ball about the centre (radius 0: none). What passes is drawn and need
/// not be in the frame.
struct Extent {
  std::vector<Eigen::Vector3d> points_V;
  double ballRadius = 0;
  std::vector<Eigen::Vector3d> passing_V = {};
};

/// The axes of a camera that stands in the scene's direction: columns to the right, up and nearer.
Eigen::Matrix3d cameraAxes_V(const scene::Camera& camera);

/// A camera in the scene's direction, as near as it can be with all of `extent` inside the margins. It depends on
/// the whole motion and not on the time: nothing breathes.
///
/// Its zoom enlarges the picture about its middle, as a longer lens does. `mostUnit_px`: pixels of a unit of V,
/// across the view at the centre of what is shown, that zoom 1 may have at most.
draw::Camera frameAll(const scene::Camera& camera, const Extent& extent, const Margins& margins, glm::vec2 size_px,
                      double mostUnit_px = std::numeric_limits<double>::infinity());

/// The pixels that a unit has where all of `extent` is as near as it can be, at zoom 1.
double fittingUnit_px(const scene::Camera& camera, const Extent& extent, const Margins& margins,
                      glm::vec2 size_px);

}  // namespace poinsot::stage
