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

/// Geometry that the frame must hold: points, and a ball about the centre (radius 0: no ball). The points in
/// `passing_V` are drawn but need not lie in the frame.
struct Extent {
  std::vector<Eigen::Vector3d> points_V;
  double ballRadius = 0;
  std::vector<Eigen::Vector3d> passing_V = {};
};

/// Returns the axes of a camera that looks in the scene's direction. The columns point right, up and towards the
/// eye.
Eigen::Matrix3d cameraAxes_V(const scene::Camera& camera);

/// Returns a camera in the scene's direction, as near as possible with all of `extent` inside the margins. The
/// extent covers the whole motion, so the scale does not change with time. The zoom enlarges the picture about its
/// middle, as a longer lens does.
/// @param mostUnit_px  limit at zoom 1 on the pixels per unit of V, across the view at the centre of the extent
draw::Camera frameAll(const scene::Camera& camera, const Extent& extent, const Margins& margins, glm::vec2 size_px,
                      double mostUnit_px = std::numeric_limits<double>::infinity());

/// Returns the pixels per unit of V at zoom 1 if the camera is as near as `extent` permits.
double fittingUnit_px(const scene::Camera& camera, const Extent& extent, const Margins& margins,
                      glm::vec2 size_px);

}  // namespace poinsot::stage
