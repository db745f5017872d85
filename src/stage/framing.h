// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "draw/camera.h"
#include "scene/scene.h"

namespace poinsot::stage {

/// Free border of the picture, as fractions of its height (top, bottom) and width (left, right).
struct Margins {
  bool operator==(const Margins&) const = default;

  double left = 0.06, right = 0.06, top = 0.06, bottom = 0.06;
};

/// Geometry that must fit into the picture: points, and a ball about the origin (radius 0: no ball). The points in
/// `passing_V` are also drawn, but they may lie outside the picture.
struct Extent {
  std::vector<Eigen::Vector3d> points_V;
  double ballRadius = 0;
  std::vector<Eigen::Vector3d> passing_V = {};
};

/// Returns the axes of a camera that looks in the scene's direction. The columns point right, up and towards the
/// eye.
Eigen::Matrix3d cameraAxes_V(const scene::Camera& camera);

/// Returns a camera that looks in the scene's direction, as near as possible with all of `extent` inside the
/// margins. The extent covers the complete motion, so the scale does not change with time. The zoom enlarges the
/// picture about its middle, as a longer lens does. The shift moves the picture sideways, without turning the
/// camera.
/// @param mostUnit_px  largest scale at zoom 1, in pixels per unit of V at the centre of the extent
draw::Camera frameAll(const scene::Camera& camera, const Extent& extent, const Margins& margins, glm::vec2 size_px,
                      double mostUnit_px = std::numeric_limits<double>::infinity());

/// Returns whether the picture of a camera cuts off a part of `extent`, because of the camera's zoom or shift.
bool cutsOff(const draw::Camera& camera, const Extent& extent);

/// Returns the largest scale at which `extent` fits into the margins, in pixels per unit of V at zoom 1.
double fittingUnit_px(const scene::Camera& camera, const Extent& extent, const Margins& margins,
                      glm::vec2 size_px);

}  // namespace poinsot::stage
