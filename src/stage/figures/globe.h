// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <glm/vec2.hpp>
#include <vector>

namespace poinsot::stage {

/// Visible half of a sphere, seen along parallel rays as a disc. Directions and points on the sphere are unit
/// vectors in any axes.
class Globe {
 public:
  using Directions = std::vector<Eigen::Vector3d>;
  using Line_px = std::vector<glm::vec2>;

  /// @param eye  direction from the sphere to the eye
  /// @param up  direction that points up in the picture. @pre not along the eye
  Globe(const Eigen::Vector3d& eye, const Eigen::Vector3d& up, glm::dvec2 centre_px, double radius_px);

  bool shows(const Eigen::Vector3d& direction) const { return seen(direction).z() >= 0; }
  /// Returns the pixel of a point that lies in a direction from the sphere's centre; y points down.
  /// @param radii  distance of the point from the centre, in radii of the sphere
  glm::vec2 at_px(const Eigen::Vector3d& direction, double radii = 1) const;

  /// Returns the visible parts of a closed curve. Parts along the rim are moved inwards by `inset_px`.
  std::vector<Line_px> visibleParts(const Directions& curve, double inset_px = 0) const;

  /// Returns the visible part of the region inside a closed curve, as a polygon; empty if the region is hidden.
  /// @pre the curve crosses the rim not at all or twice.
  /// @param inside  function that returns true if a direction lies in the region
  Line_px visiblePart(const Directions& curve, const std::function<bool(const Eigen::Vector3d&)>& inside) const;

  Line_px rim() const;

 private:
  /// Returns the components of a direction to the right, up and towards the eye.
  Eigen::Vector3d seen(const Eigen::Vector3d& direction) const { return axes_.transpose() * direction; }
  glm::vec2 placed_px(const Eigen::Vector2d& right_up) const;
  /// Returns the visible pieces of a closed curve. Each piece runs from rim to rim. If nothing is hidden, the only
  /// piece is the complete curve.
  std::vector<Directions> visibleRuns(const Directions& curve) const;
  void addRim(Line_px& polygon, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
              const std::function<bool(const Eigen::Vector3d&)>& inside) const;

  Eigen::Matrix3d axes_;
  glm::dvec2 centre_px_;
  double radius_px_;
};

}  // namespace poinsot::stage
