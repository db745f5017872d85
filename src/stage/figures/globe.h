// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <glm/vec2.hpp>
#include <vector>

namespace poinsot::stage {

/// A sphere seen along parallel rays: half of it, as a disc. Directions and points on it in any axes, unit.
class Globe {
 public:
  using Directions = std::vector<Eigen::Vector3d>;
  using Line_px = std::vector<glm::vec2>;

  /// @param eye  from where it is seen
  /// @param up  points up in the picture. @pre not along the eye
  Globe(const Eigen::Vector3d& eye, const Eigen::Vector3d& up, glm::dvec2 centre_px, double radius_px);

  bool shows(const Eigen::Vector3d& direction) const { return seen(direction).z() >= 0; }
  /// Of a point at this distance from the centre, in radii; y down.
  glm::vec2 at_px(const Eigen::Vector3d& direction, double radii = 1) const;

  /// What is seen of a closed curve. Where it runs along the rim it keeps so far inside.
  std::vector<Line_px> visibleParts(const Directions& curve, double inset_px = 0) const;

  /// What is seen of the part of the sphere that a closed curve goes round, as a polygon; empty where nothing is.
  /// @pre the curve crosses the rim not at all or twice.
  /// @param inside  whether a direction is in that part
  Line_px visiblePart(const Directions& curve, const std::function<bool(const Eigen::Vector3d&)>& inside) const;

  Line_px rim() const;

 private:
  /// To the right, up and to the eye.
  Eigen::Vector3d seen(const Eigen::Vector3d& direction) const { return axes_.transpose() * direction; }
  glm::vec2 placed_px(const Eigen::Vector2d& right_up) const;
  /// The runs of a closed curve's points that are seen, each from rim to rim; whole where nothing is hidden.
  std::vector<Directions> visibleRuns(const Directions& curve) const;
  void addRim(Line_px& polygon, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
              const std::function<bool(const Eigen::Vector3d&)>& inside) const;

  Eigen::Matrix3d axes_;  // columns: to the right, up and to the eye
  glm::dvec2 centre_px_;
  double radius_px_;
};

}  // namespace poinsot::stage
